(* Printed from renderer/shader by `python -m renderer.generate`. Do not edit: change the shader.
   A pixel's program, recorded from the shader: the places of inputs and outputs by their names; then the lines, each an
   operation and the places of what it takes. A selection takes two numbers, and those that its condition compares. *)

From Coq Require Import List NArith ZArith.
Import ListNotations.

Module recorded_pixel.
Inductive condition : Type := Less (i j : nat) | At_most (i j : nat) | Same (i j : nat)
  | Not (c : condition) | Both (c d : condition) | Either (c d : condition).
Inductive operation : Type := Literal (m e : Z) | Infinite | Constant (m e : Z) | Negative | Size | Sum | Difference
  | Product | Quotient | Root | Floor | Nearest | Sine | Cosine | Angle | Power | Choose (c : condition).
Definition x : list nat := [0].
Definition y : list nat := [1].
Definition h_u : list nat := [2].
Definition h_v : list nat := [3].
Definition eye : list nat := [4].
Definition radius : list nat := [5].
Definition ku : list nat := [6].
Definition kv : list nat := [7].
Definition beta : list nat := [8].
Definition ka : list nat := [9].
Definition kd : list nat := [10].
Definition ks : list nat := [11].
Definition albedo_a : list nat := [12; 13; 14].
Definition albedo_b : list nat := [15; 16; 17].
Definition ball : list nat := [18; 19; 20; 21].
Definition ball_on : list nat := [22].
Definition floor_on : list nat := [23].
Definition ground : list nat := [24].
Definition reach_of_a : list nat := [25].
Definition box_of_b : list nat := [26; 27; 28; 29].
Definition way : list nat := [30].
Definition model : list nat := [31].
Definition bump : list nat := [32].
Definition eps : list nat := [33].
Definition power_u : list nat := [34].
Definition power_v : list nat := [35].
Definition turn_u : list nat := [36].
Definition turn_v : list nat := [37].
Definition power : list nat := [38].
Definition ambient_light : list nat := [39; 40; 41].
Definition ambient : list nat := [42; 43; 44].
Definition floor_light : list nat := [45; 46].
Definition floor_dark : list nat := [47; 48].
Definition light_position : list nat := [49; 50; 51; 74; 75; 76; 99; 100; 101; 124; 125; 126; 149; 150; 151].
Definition light_color : list nat := [52; 53; 54; 77; 78; 79; 102; 103; 104; 127; 128; 129; 152; 153; 154].
Definition light_glows : list nat := [55; 80; 105; 130; 155].
Definition light_bit : list nat := [56; 81; 106; 131; 156].
Definition light_inverse_bit : list nat := [57; 82; 107; 132; 157].
Definition light_a_on_floor : list nat := [58; 59; 60; 61; 83; 84; 85; 86; 108; 109; 110; 111; 133; 134; 135; 136; 158;
159; 160; 161].
Definition light_b_on_floor : list nat := [62; 63; 64; 65; 87; 88; 89; 90; 112; 113; 114; 115; 137; 138; 139; 140; 162;
163; 164; 165].
Definition light_b_on_a : list nat := [66; 67; 68; 69; 91; 92; 93; 94; 116; 117; 118; 119; 141; 142; 143; 144; 166; 167;
168; 169].
Definition light_a_on_b : list nat := [70; 71; 72; 73; 95; 96; 97; 98; 120; 121; 122; 123; 145; 146; 147; 148; 170; 171;
172; 173].
Definition normal : list nat := [486; 529; 177; 614].
Definition code : list nat := [548; 997; 1630; 2261; 2896; 3535].
Definition red : list nat := [551; 1111; 1152; 1266; 1735; 1785; 1893; 2366; 2416; 2524; 3001; 3051; 3159; 3640; 3690;
3798].
Definition green : list nat := [552; 1114; 1155; 1269; 1738; 1788; 1896; 2369; 2419; 2527; 3004; 3054; 3162; 3643; 3693;
3801].
Definition blue : list nat := [553; 1117; 1158; 1272; 1741; 1791; 1899; 2372; 2422; 2530; 3007; 3057; 3165; 3646; 3696;
3804].
Definition inputs : nat := 174.
Open Scope N_scope.
Definition from_0 : list (operation * list N) := [(Product, [0; 0]); (Product, [1; 1]); (Sum, [174; 175]); (Literal (1)
(0), []); (Choose (At_most 0 1), [177; 24; 176; 25]); (Root, [176]); (Constant (7371020360979573) (-551), []); (Product,
[180; 4]); (Literal (0) (0), []); (Choose (At_most 0 1), [179; 182; 181; 179]); (Difference, [4; 5]); (Sum, [4; 5]);
(Product, [184; 185]); (Product, [4; 5]); (Root, [186]); (Quotient, [187; 188]); (Difference, [189; 183]); (Product,
[186; 190]); (Sum, [183; 189]); (Product, [191; 192]); (Choose (Less 0 1), [193; 182; 182; 193]); (Root, [194]);
(Product, [4; 4]); (Sum, [196; 195]); (Quotient, [186; 197]); (Infinite, []); (Choose (At_most 0 1), [198; 199; 182;
193]); (Difference, [4; 20]); (Product, [18; 0]); (Product, [19; 1]); (Sum, [202; 203]); (Product, [201; 4]); (Sum,
[204; 205]); (Product, [21; 21]); (Sum, [196; 174]); (Sum, [208; 175]); (Product, [207; 209]); (Product, [18; 4]);
(Product, [201; 0]); (Difference, [211; 212]); (Product, [213; 213]); (Difference, [210; 214]); (Product, [18; 1]);
(Product, [19; 0]); (Difference, [216; 217]); (Product, [218; 218]); (Difference, [215; 219]); (Product, [201; 1]);
(Product, [19; 4]); (Difference, [221; 222])].
Definition from_50 : list (operation * list N) := [(Product, [223; 223]); (Difference, [220; 224]); (Choose (Less 0 1),
[225; 182; 182; 225]); (Root, [226]); (Product, [18; 18]); (Product, [19; 19]); (Sum, [228; 229]); (Difference, [201;
21]); (Sum, [21; 201]); (Product, [231; 232]); (Sum, [230; 233]); (Sum, [227; 206]); (Quotient, [234; 235]); (Choose
(Both (Both (Less 0 1) (At_most 0 2)) (Less 0 3)), [236; 199; 182; 22; 225; 206]); (Choose (Less 0 1), [177; 199; 182;
23]); (Literal (3) (0), []); (Choose (Less 0 1), [239; 182; 238; 199]); (Literal (2) (0), []); (Choose (Both (Less 0 1)
(At_most 0 2)), [241; 240; 237; 199; 238]); (Choose (Both (Both (Less 0 1) (At_most 0 2)) (At_most 0 3)), [177; 242;
200; 199; 237; 238]); (Choose (Both (Both (Both (At_most 0 1) (At_most 1 2)) (At_most 3 4)) (At_most 4 5)), [243; 178;
26; 0; 27; 28; 1; 29]); (Quotient, [177; 183]); (Choose (Less 0 1), [245; 182; 182; 183]); (Product, [5; 197]);
(Quotient, [177; 247]); (Product, [246; 0]); (Product, [246; 1]); (Product, [248; 183]); (Product, [251; 186]);
(Product, [4; 248]); (Product, [5; 5]); (Sum, [254; 195]); (Product, [253; 255]); (Angle, [250; 249]); (Literal (1)
(-1), []); (Product, [258; 257]); (Sum, [259; 258]); (Choose (Less 0 1), [260; 182; 260; 177]); (Angle, [252; 256]);
(Cosine, [6; 261]); (Cosine, [7; 262]); (Sine, [6; 261]); (Sine, [7; 262]); (Constant (884279719003555) (-48), []);
(Product, [267; 263]); (Product, [268; 6]); (Product, [269; 266]); (Product, [267; 264]); (Product, [271; 7]); (Product,
[272; 265])].
Definition from_100 : list (operation * list N) := [(Sum, [33; 261]); (Floor, [274]); (Difference, [274; 275]); (Sum,
[33; 262]); (Difference, [262; 33]); (Choose (At_most 0 1), [277; 278; 277; 177]); (Product, [265; 266]); (Sine, [6;
276]); (Product, [281; 266]); (Sine, [7; 279]); (Product, [265; 283]); (Difference, [282; 280]); (Quotient, [285; 33]);
(Difference, [284; 280]); (Quotient, [287; 33]); (Difference, [280; 284]); (Quotient, [289; 33]); (Choose (At_most 0 1),
[288; 290; 277; 177]); (Choose (Same 0 1), [286; 270; 30; 177]); (Choose (Same 0 1), [291; 273; 30; 177]); (Difference,
[261; 33]); (Floor, [294]); (Difference, [294; 295]); (Choose (Less 0 1), [277; 177; 277; 177]); (Choose (Less 0 1),
[278; 182; 182; 278]); (Difference, [33; 262]); (Product, [241; 33]); (Difference, [297; 298]); (Choose (Both (At_most 0
1) (At_most 2 3)), [300; 301; 277; 177; 299; 182]); (Sine, [6; 296]); (Product, [303; 266]); (Sine, [7; 297]); (Product,
[265; 305]); (Sine, [7; 298]); (Product, [265; 307]); (Difference, [282; 304]); (Product, [258; 309]); (Quotient, [310;
33]); (Difference, [306; 308]); (Quotient, [312; 302]); (Choose (Same 0 1), [311; 292; 30; 241]); (Choose (Same 0 1),
[313; 293; 30; 241]); (Sum, [300; 261]); (Floor, [316]); (Difference, [316; 317]); (Difference, [261; 300]); (Floor,
[319]); (Difference, [319; 320]); (Sum, [300; 262]); (Choose (Less 0 1), [322; 177; 322; 177])].
Definition from_150 : list (operation * list N) := [(Difference, [262; 300]); (Choose (Less 0 1), [324; 182; 182; 324]);
(Sine, [6; 318]); (Product, [326; 266]); (Sine, [6; 321]); (Product, [328; 266]); (Sine, [7; 323]); (Product, [265;
330]); (Sine, [7; 325]); (Product, [265; 332]); (Difference, [329; 327]); (Literal (8) (0), []); (Product, [335; 309]);
(Sum, [334; 336]); (Constant (6004799503160661) (-56), []); (Product, [338; 337]); (Quotient, [339; 33]); (Difference,
[300; 262]); (Difference, [333; 331]); (Product, [335; 312]); (Sum, [342; 343]); (Product, [338; 344]); (Quotient, [345;
33]); (Choose (Both (At_most 0 1) (At_most 2 3)), [346; 313; 322; 177; 341; 182]); (Choose (Same 0 1), [340; 314; 30;
239]); (Choose (Same 0 1), [347; 315; 30; 239]); (Literal (-1) (0), []); (Choose (Less 0 1), [350; 182; 265; 182]);
(Choose (Less 0 1), [177; 351; 182; 265]); (Choose (Less 0 1), [350; 182; 266; 182]); (Choose (Less 0 1), [177; 353;
182; 266]); (Product, [352; 354]); (Product, [270; 355]); (Product, [273; 355]); (Literal (4) (0), []); (Choose (Same 0
1), [356; 348; 30; 358]); (Choose (Same 0 1), [357; 349; 30; 358]); (Size, [280]); (Size, [282]); (Size, [284]);
(Difference, [362; 361]); (Quotient, [364; 33]); (Difference, [363; 361]); (Quotient, [366; 33]); (Difference, [361;
363]); (Quotient, [368; 33]); (Choose (At_most 0 1), [367; 369; 277; 177]); (Literal (5) (0), []); (Choose (Same 0 1),
[365; 359; 30; 371]); (Choose (Same 0 1), [370; 360; 30; 371])].
Definition from_200 : list (operation * list N) := [(Size, [304]); (Size, [306]); (Size, [308]); (Difference, [362;
374]); (Product, [258; 377]); (Quotient, [378; 33]); (Difference, [375; 376]); (Quotient, [380; 302]); (Literal (6) (0),
[]); (Choose (Same 0 1), [379; 372; 30; 382]); (Choose (Same 0 1), [381; 373; 30; 382]); (Size, [327]); (Size, [329]);
(Size, [331]); (Size, [333]); (Difference, [386; 385]); (Product, [335; 377]); (Sum, [389; 390]); (Product, [338; 391]);
(Quotient, [392; 33]); (Difference, [388; 387]); (Product, [335; 380]); (Sum, [394; 395]); (Product, [338; 396]);
(Quotient, [397; 33]); (Choose (Both (At_most 0 1) (At_most 2 3)), [398; 381; 322; 177; 341; 182]); (Literal (7) (0),
[]); (Choose (Same 0 1), [393; 383; 30; 400]); (Choose (Same 0 1), [399; 384; 30; 400]); (Product, [241; 7]); (Cosine,
[403; 262]); (Constant (884279719003555) (-47), []); (Product, [405; 404]); (Product, [406; 7]); (Choose (Same 0 1),
[182; 401; 30; 335]); (Choose (Same 0 1), [407; 402; 30; 335]); (Sine, [403; 262]); (Sine, [403; 279]); (Difference,
[411; 410]); (Quotient, [412; 33]); (Difference, [410; 411]); (Quotient, [414; 33]); (Choose (At_most 0 1), [413; 415;
277; 177]); (Literal (9) (0), []); (Choose (Same 0 1), [182; 408; 30; 417]); (Choose (Same 0 1), [416; 409; 30; 417]);
(Sine, [403; 297]); (Sine, [403; 298]); (Difference, [420; 421]); (Quotient, [422; 302])].
Definition from_250 : list (operation * list N) := [(Literal (10) (0), []); (Choose (Same 0 1), [182; 418; 30; 424]);
(Choose (Same 0 1), [423; 419; 30; 424]); (Sine, [403; 323]); (Sine, [403; 325]); (Difference, [428; 427]); (Product,
[335; 422]); (Sum, [429; 430]); (Product, [338; 431]); (Quotient, [432; 33]); (Choose (Both (At_most 0 1) (At_most 2
3)), [433; 423; 322; 177; 341; 182]); (Literal (11) (0), []); (Choose (Same 0 1), [182; 425; 30; 435]); (Choose (Same 0
1), [434; 426; 30; 435]); (Literal (12) (0), []); (Choose (Same 0 1), [2; 436; 30; 438]); (Choose (Same 0 1), [3; 437;
30; 438]); (Constant (-884279719003555) (-48), []); (Product, [441; 5]); (Product, [258; 439]); (Product, [442; 252]);
(Quotient, [443; 444]); (Choose (Less 0 1), [445; 182; 182; 252]); (Quotient, [440; 442]); (Choose (Less 0 1), [447;
182; 182; 252]); (Choose (Same 0 1), [446; 439; 32; 177]); (Choose (Same 0 1), [448; 440; 32; 177]); (Product, [249;
5]); (Product, [451; 252]); (Product, [5; 252]); (Product, [453; 250]); (Product, [256; 5]); (Product, [249; 252]);
(Product, [252; 250]); (Negative, [250]); (Product, [256; 249]); (Product, [256; 250]); (Negative, [252]); (Product,
[459; 450]); (Product, [458; 449]); (Sum, [462; 463]); (Product, [460; 450]); (Product, [249; 449]); (Sum, [465; 466]);
(Product, [461; 450]); (Product, [182; 449]); (Sum, [468; 469]); (Product, [8; 464]); (Sum, [471; 456]); (Product, [8;
467])].
Definition from_300 : list (operation * list N) := [(Sum, [473; 457]); (Product, [8; 470]); (Sum, [475; 256]); (Product,
[472; 472]); (Product, [474; 474]); (Sum, [477; 478]); (Product, [476; 476]); (Sum, [479; 480]); (Root, [481]);
(Quotient, [177; 482]); (Product, [483; 472]); (Product, [483; 474]); (Product, [483; 476]); (Root, [209]); (Quotient,
[177; 487]); (Negative, [488]); (Product, [489; 0]); (Product, [489; 1]); (Product, [4; 488]); (Choose (Less 0 1), [42;
182; 182; 42]); (Choose (Less 0 1), [493; 177; 493; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [494; 182; 244; 177;
0]); (Choose (Less 0 1), [43; 182; 182; 43]); (Choose (Less 0 1), [496; 177; 496; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [497; 182; 244; 177; 0]); (Choose (Less 0 1), [44; 182; 182; 44]); (Choose (Less 0 1), [499; 177; 499; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [500; 182; 244; 177; 0]); (Negative, [4]); (Product, [502; 213]); (Product, [218;
1]); (Difference, [503; 504]); (Product, [227; 0]); (Difference, [505; 506]); (Quotient, [507; 209]); (Product, [4;
223]); (Product, [218; 0]); (Sum, [509; 510]); (Product, [227; 1]); (Difference, [511; 512]); (Quotient, [513; 209]);
(Product, [4; 227]); (Product, [223; 1]); (Sum, [515; 516]); (Product, [213; 0]); (Difference, [517; 518]); (Quotient,
[519; 209]); (Product, [508; 508]); (Product, [514; 514]); (Sum, [521; 522])].
Definition from_350 : list (operation * list N) := [(Product, [520; 520]); (Sum, [523; 524]); (Root, [525]); (Quotient,
[508; 526]); (Quotient, [514; 526]); (Quotient, [520; 526]); (Product, [21; 527]); (Sum, [18; 530]); (Product, [21;
528]); (Sum, [19; 532]); (Product, [21; 529]); (Sum, [20; 534]); (Choose (Both (Same 0 1) (Same 2 2)), [494; 495; 244;
241; 0]); (Choose (Both (Same 0 1) (Same 2 2)), [497; 498; 244; 241; 0]); (Choose (Both (Same 0 1) (Same 2 2)), [500;
501; 244; 241; 0]); (Floor, [0]); (Floor, [1]); (Sum, [539; 540]); (Product, [258; 541]); (Floor, [542]); (Product,
[241; 543]); (Choose (Both (Both (Not (Same 0 1)) (Not (Same 2 3))) (Not (Same 4 5))), [177; 182; 0; 539; 1; 540; 541;
544]); (Literal (128) (0), []); (Sum, [244; 546]); (Choose (Both (Both (Same 0 1) (Same 2 2)) (Less 3 4)), [547; 244;
244; 239; 0; 182; 545]); (Choose (Less 0 1), [47; 45; 182; 545]); (Choose (Less 0 1), [48; 46; 182; 545]); (Choose (Both
(Same 0 1) (Same 2 2)), [494; 536; 244; 239; 0]); (Choose (Both (Same 0 1) (Same 2 2)), [497; 537; 244; 239; 0]);
(Choose (Both (Same 0 1) (Same 2 2)), [500; 538; 244; 239; 0]); (Negative, [249]); (Product, [36; 458]); (Difference,
[554; 555]); (Sum, [555; 554]); (Product, [556; 557]); (Product, [241; 555]); (Product, [559; 554]); (Difference, [558;
560]); (Sum, [560; 558]); (Product, [561; 562]); (Product, [241; 560]); (Product, [564; 558]); (Product, [37; 252]);
(Difference, [256; 566]); (Sum, [566; 256]); (Product, [567; 568]); (Product, [241; 566]); (Product, [570; 256]);
(Difference, [569; 571]); (Sum, [571; 569])].
Definition from_400 : list (operation * list N) := [(Product, [572; 573]); (Product, [241; 571]); (Product, [575; 569]);
(Product, [267; 563]); (Product, [577; 6]); (Product, [578; 576]); (Choose (Less 0 1), [350; 182; 565; 182]); (Choose
(Less 0 1), [177; 580; 182; 565]); (Choose (Less 0 1), [350; 182; 576; 182]); (Choose (Less 0 1), [177; 582; 182; 576]);
(Product, [581; 583]); (Product, [579; 584]); (Product, [267; 574]); (Product, [586; 7]); (Product, [587; 565]);
(Product, [588; 584]); (Product, [459; 589]); (Product, [458; 585]); (Sum, [590; 591]); (Product, [460; 589]); (Product,
[249; 585]); (Sum, [593; 594]); (Product, [461; 589]); (Product, [182; 585]); (Sum, [596; 597]); (Product, [8; 592]);
(Sum, [599; 456]); (Product, [8; 595]); (Sum, [601; 457]); (Product, [8; 598]); (Sum, [603; 256]); (Product, [600;
600]); (Product, [602; 602]); (Sum, [605; 606]); (Product, [604; 604]); (Sum, [607; 608]); (Root, [609]); (Quotient,
[177; 610]); (Product, [611; 600]); (Product, [611; 602]); (Product, [611; 604]); (Difference, [49; 452]); (Difference,
[50; 454]); (Difference, [51; 455]); (Difference, [18; 452]); (Difference, [19; 454]); (Difference, [20; 455]);
(Product, [615; 615]); (Product, [616; 616]); (Sum, [621; 622])].
Definition from_450 : list (operation * list N) := [(Product, [617; 617]); (Sum, [623; 624]); (Product, [618; 615]);
(Product, [619; 616]); (Sum, [626; 627]); (Product, [620; 617]); (Sum, [628; 629]); (Product, [207; 625]); (Product,
[619; 615]); (Product, [618; 616]); (Difference, [632; 633]); (Product, [634; 634]); (Difference, [631; 635]); (Product,
[618; 617]); (Product, [620; 615]); (Difference, [637; 638]); (Product, [639; 639]); (Difference, [636; 640]); (Product,
[620; 616]); (Product, [619; 617]); (Difference, [642; 643]); (Product, [644; 644]); (Difference, [641; 645]); (Choose
(Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 630; 625; 182; 646]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244;
177; 0; 66; 67; 68; 1; 69; 182; 647]); (Sum, [244; 56]); (Choose (Less 0 1), [649; 244; 182; 648]); (Root, [625]);
(Quotient, [177; 651]); (Product, [652; 615]); (Product, [652; 616]); (Product, [652; 617]); (Product, [484; 653]);
(Product, [485; 654]); (Sum, [656; 657]); (Product, [486; 655]); (Sum, [658; 659]); (Sum, [653; 490]); (Sum, [654;
491]); (Sum, [655; 492]); (Product, [661; 661]); (Product, [662; 662]); (Sum, [664; 665]); (Product, [663; 663]); (Sum,
[666; 667]); (Root, [668]); (Product, [484; 661]); (Product, [485; 662]); (Sum, [670; 671]); (Product, [486; 663])].
Definition from_500 : list (operation * list N) := [(Sum, [672; 673]); (Quotient, [674; 669]); (Choose (Less 0 1), [675;
182; 182; 675]); (Choose (Less 0 1), [676; 182; 182; 669]); (Power, [677; 38]); (Choose (Same 0 1), [660; 660; 31;
177]); (Choose (Same 0 1), [182; 678; 31; 177]); (Product, [651; 490]); (Sum, [681; 615]); (Product, [651; 491]); (Sum,
[683; 616]); (Product, [651; 492]); (Sum, [685; 617]); (Product, [682; 682]); (Product, [684; 684]); (Sum, [687; 688]);
(Product, [686; 686]); (Sum, [689; 690]); (Product, [484; 615]); (Product, [485; 616]); (Sum, [692; 693]); (Product,
[486; 617]); (Sum, [694; 695]); (Product, [484; 682]); (Product, [485; 684]); (Sum, [697; 698]); (Product, [486; 686]);
(Sum, [699; 700]); (Choose (Less 0 1), [701; 182; 182; 701]); (Product, [691; 651]); (Quotient, [177; 703]); (Choose
(Less 0 1), [704; 182; 182; 691]); (Product, [696; 691]); (Product, [706; 705]); (Negative, [484]); (Product, [708;
490]); (Product, [485; 491]); (Difference, [709; 710]); (Product, [486; 492]); (Difference, [711; 712]); (Choose (Less 0
1), [707; 713; 182; 691]); (Product, [702; 702]); (Product, [715; 651]); (Product, [716; 705]); (Power, [717; 38]);
(Choose (Same 0 1), [714; 679; 31; 241]); (Choose (Same 0 1), [718; 680; 31; 241]); (Product, [241; 660]); (Product,
[484; 490]); (Sum, [722; 710])].
Definition from_550 : list (operation * list N) := [(Sum, [723; 712]); (Product, [721; 724]); (Product, [653; 490]);
(Difference, [725; 726]); (Product, [654; 491]); (Difference, [727; 728]); (Product, [655; 492]); (Difference, [729;
730]); (Choose (Less 0 1), [731; 182; 182; 731]); (Power, [732; 38]); (Choose (Same 0 1), [660; 719; 31; 239]); (Choose
(Same 0 1), [733; 720; 31; 239]); (Choose (Same 0 1), [660; 734; 31; 358]); (Choose (Same 0 1), [182; 735; 31; 358]);
(Choose (Less 0 1), [677; 182; 182; 660]); (Power, [738; 38]); (Choose (Same 0 1), [660; 736; 31; 371]); (Choose (Same 0
1), [739; 737; 31; 371]); (Choose (Same 0 1), [660; 740; 31; 382]); (Choose (Same 0 1), [182; 741; 31; 382]); (Choose
(Less 0 1), [717; 182; 182; 714]); (Power, [744; 38]); (Choose (Same 0 1), [714; 742; 31; 400]); (Choose (Same 0 1),
[745; 743; 31; 400]); (Choose (Less 0 1), [746; 182; 182; 746]); (Product, [10; 748]); (Product, [11; 747]); (Product,
[12; 749]); (Sum, [751; 750]); (Product, [52; 752]); (Sum, [753; 42]); (Product, [13; 749]); (Sum, [755; 750]);
(Product, [53; 756]); (Sum, [43; 757]); (Product, [14; 749]); (Sum, [759; 750]); (Product, [54; 760]); (Sum, [44; 761]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [754; 42; 244; 177; 0; 182; 648; 55]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [758; 43; 244; 177; 0; 182; 648; 55]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [762; 44; 244; 177; 0; 182; 648; 55]);
(Choose (Less 0 1), [763; 182; 182; 763]); (Choose (Less 0 1), [766; 177; 766; 177]); (Choose (Both (Same 0 1) (Same 2
2)), [767; 182; 244; 177; 0]); (Choose (Less 0 1), [764; 182; 182; 764]); (Choose (Less 0 1), [769; 177; 769; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [770; 182; 244; 177; 0]); (Choose (Less 0 1), [765; 182; 182; 765]); (Choose (Less
0 1), [772; 177; 772; 177])].
Definition from_600 : list (operation * list N) := [(Choose (Both (Same 0 1) (Same 2 2)), [773; 182; 244; 177; 0]);
(Difference, [49; 531]); (Difference, [50; 533]); (Difference, [51; 535]); (Difference, [182; 531]); (Difference, [182;
533]); (Difference, [182; 535]); (Product, [775; 775]); (Product, [776; 776]); (Sum, [781; 782]); (Product, [777; 777]);
(Sum, [783; 784]); (Product, [778; 775]); (Product, [779; 776]); (Sum, [786; 787]); (Product, [780; 777]); (Sum, [788;
789]); (Product, [254; 785]); (Product, [779; 775]); (Product, [778; 776]); (Difference, [792; 793]); (Product, [794;
794]); (Difference, [791; 795]); (Product, [778; 777]); (Product, [780; 775]); (Difference, [797; 798]); (Product, [799;
799]); (Difference, [796; 800]); (Product, [780; 776]); (Product, [779; 777]); (Difference, [802; 803]); (Product, [804;
804]); (Difference, [801; 805]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 790; 785; 182;
806]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6))
(At_most 6 7))) (Less 8 9)), [177; 182; 244; 241; 0; 70; 71; 72; 1; 73; 182; 807]); (Sum, [650; 56]); (Choose (Less 0
1), [809; 650; 182; 808]); (Root, [785]); (Quotient, [177; 811]); (Product, [812; 775]); (Product, [812; 776]);
(Product, [812; 777]); (Product, [527; 813]); (Product, [528; 814]); (Sum, [816; 817]); (Product, [529; 815]); (Sum,
[818; 819]); (Sum, [813; 490]); (Sum, [814; 491]); (Sum, [815; 492])].
Definition from_650 : list (operation * list N) := [(Product, [821; 821]); (Product, [822; 822]); (Sum, [824; 825]);
(Product, [823; 823]); (Sum, [826; 827]); (Root, [828]); (Product, [527; 821]); (Product, [528; 822]); (Sum, [830;
831]); (Product, [529; 823]); (Sum, [832; 833]); (Quotient, [834; 829]); (Choose (Less 0 1), [835; 182; 182; 835]);
(Choose (Less 0 1), [836; 182; 182; 829]); (Power, [837; 38]); (Choose (Same 0 1), [820; 820; 31; 177]); (Choose (Same 0
1), [182; 838; 31; 177]); (Product, [811; 490]); (Sum, [841; 775]); (Product, [811; 491]); (Sum, [843; 776]); (Product,
[811; 492]); (Sum, [845; 777]); (Product, [842; 842]); (Product, [844; 844]); (Sum, [847; 848]); (Product, [846; 846]);
(Sum, [849; 850]); (Product, [527; 775]); (Product, [528; 776]); (Sum, [852; 853]); (Product, [529; 777]); (Sum, [854;
855]); (Product, [527; 842]); (Product, [528; 844]); (Sum, [857; 858]); (Product, [529; 846]); (Sum, [859; 860]);
(Choose (Less 0 1), [861; 182; 182; 861]); (Product, [851; 811]); (Quotient, [177; 863]); (Choose (Less 0 1), [864; 182;
182; 851]); (Product, [856; 851]); (Product, [866; 865]); (Negative, [527]); (Product, [868; 490]); (Product, [528;
491]); (Difference, [869; 870]); (Product, [529; 492]); (Difference, [871; 872])].
Definition from_700 : list (operation * list N) := [(Choose (Less 0 1), [867; 873; 182; 851]); (Product, [862; 862]);
(Product, [875; 811]); (Product, [876; 865]); (Power, [877; 38]); (Choose (Same 0 1), [874; 839; 31; 241]); (Choose
(Same 0 1), [878; 840; 31; 241]); (Product, [241; 820]); (Product, [527; 490]); (Sum, [882; 870]); (Sum, [883; 872]);
(Product, [881; 884]); (Product, [813; 490]); (Difference, [885; 886]); (Product, [814; 491]); (Difference, [887; 888]);
(Product, [815; 492]); (Difference, [889; 890]); (Choose (Less 0 1), [891; 182; 182; 891]); (Power, [892; 38]); (Choose
(Same 0 1), [820; 879; 31; 239]); (Choose (Same 0 1), [893; 880; 31; 239]); (Choose (Same 0 1), [820; 894; 31; 358]);
(Choose (Same 0 1), [182; 895; 31; 358]); (Choose (Less 0 1), [837; 182; 182; 820]); (Power, [898; 38]); (Choose (Same 0
1), [820; 896; 31; 371]); (Choose (Same 0 1), [899; 897; 31; 371]); (Choose (Same 0 1), [820; 900; 31; 382]); (Choose
(Same 0 1), [182; 901; 31; 382]); (Choose (Less 0 1), [877; 182; 182; 874]); (Power, [904; 38]); (Choose (Same 0 1),
[874; 902; 31; 400]); (Choose (Same 0 1), [905; 903; 31; 400]); (Choose (Less 0 1), [906; 182; 182; 906]); (Product,
[10; 908]); (Product, [11; 907]); (Product, [15; 909]); (Sum, [911; 910]); (Product, [52; 912]); (Sum, [913; 42]);
(Product, [16; 909]); (Sum, [915; 910]); (Product, [53; 916]); (Sum, [43; 917]); (Product, [17; 909]); (Sum, [919;
910]); (Product, [54; 920]); (Sum, [44; 921]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less
3 5)), [914; 42; 244; 241; 0; 182; 808; 55])].
Definition from_750 : list (operation * list N) := [(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4)))
(Less 3 5)), [918; 43; 244; 241; 0; 182; 808; 55]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4)))
(Less 3 5)), [922; 44; 244; 241; 0; 182; 808; 55]); (Choose (Less 0 1), [923; 182; 182; 923]); (Choose (Less 0 1), [926;
177; 926; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [927; 768; 244; 241; 0]); (Choose (Less 0 1), [924; 182; 182;
924]); (Choose (Less 0 1), [929; 177; 929; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [930; 771; 244; 241; 0]);
(Choose (Less 0 1), [925; 182; 182; 925]); (Choose (Less 0 1), [932; 177; 932; 177]); (Choose (Both (Same 0 1) (Same 2
2)), [933; 774; 244; 241; 0]); (Sum, [810; 546]); (Choose (Both (Both (Same 0 1) (Same 2 2)) (Less 3 4)), [935; 810;
244; 239; 0; 182; 545]); (Difference, [49; 0]); (Difference, [50; 1]); (Difference, [51; 182]); (Difference, [182; 0]);
(Difference, [182; 1]); (Product, [937; 937]); (Product, [938; 938]); (Sum, [942; 943]); (Product, [939; 939]); (Sum,
[944; 945]); (Product, [940; 937]); (Product, [941; 938]); (Sum, [947; 948]); (Product, [182; 939]); (Sum, [949; 950]);
(Product, [254; 946]); (Product, [941; 937]); (Product, [940; 938]); (Difference, [953; 954]); (Product, [955; 955]);
(Difference, [952; 956]); (Product, [940; 939]); (Product, [182; 937]); (Difference, [958; 959]); (Product, [960; 960]);
(Difference, [957; 961]); (Product, [182; 938]); (Product, [941; 939]); (Difference, [963; 964]); (Product, [965; 965]);
(Difference, [962; 966]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 951; 946; 182; 967]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most
6 7))) (Less 8 9)), [177; 182; 244; 239; 0; 58; 59; 60; 1; 61; 182; 968]); (Difference, [18; 0]); (Difference, [19; 1]);
(Difference, [20; 182]); (Product, [970; 937])].
Definition from_800 : list (operation * list N) := [(Product, [971; 938]); (Sum, [973; 974]); (Product, [972; 939]);
(Sum, [975; 976]); (Product, [207; 946]); (Product, [971; 937]); (Product, [970; 938]); (Difference, [979; 980]);
(Product, [981; 981]); (Difference, [978; 982]); (Product, [970; 939]); (Product, [972; 937]); (Difference, [984; 985]);
(Product, [986; 986]); (Difference, [983; 987]); (Product, [972; 938]); (Product, [971; 939]); (Difference, [989; 990]);
(Product, [991; 991]); (Difference, [988; 992]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182;
977; 946; 182; 993]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4))
(At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 969; 244; 239; 0; 62; 63; 64; 1; 65; 182; 994]); (Sum, [936; 56]);
(Choose (Less 0 1), [996; 936; 182; 995]); (Root, [946]); (Quotient, [177; 998]); (Product, [999; 937]); (Product, [999;
938]); (Product, [999; 939]); (Product, [182; 1000]); (Product, [182; 1001]); (Sum, [1003; 1004]); (Product, [177;
1002]); (Sum, [1005; 1006]); (Sum, [1000; 490]); (Sum, [1001; 491]); (Sum, [1002; 492]); (Product, [1008; 1008]);
(Product, [1009; 1009]); (Sum, [1011; 1012]); (Product, [1010; 1010]); (Sum, [1013; 1014]); (Root, [1015]); (Product,
[182; 1008]); (Product, [182; 1009]); (Sum, [1017; 1018]); (Product, [177; 1010]); (Sum, [1019; 1020]); (Quotient,
[1021; 1016]); (Choose (Less 0 1), [1022; 182; 182; 1022])].
Definition from_850 : list (operation * list N) := [(Choose (Less 0 1), [1023; 182; 182; 1016]); (Power, [1024; 38]);
(Choose (Same 0 1), [1007; 1007; 31; 177]); (Choose (Same 0 1), [182; 1025; 31; 177]); (Product, [998; 490]); (Sum,
[1028; 937]); (Product, [998; 491]); (Sum, [1030; 938]); (Product, [998; 492]); (Sum, [1032; 939]); (Product, [1029;
1029]); (Product, [1031; 1031]); (Sum, [1034; 1035]); (Product, [1033; 1033]); (Sum, [1036; 1037]); (Sum, [959; 963]);
(Product, [177; 939]); (Sum, [1039; 1040]); (Product, [182; 1029]); (Product, [182; 1031]); (Sum, [1042; 1043]);
(Product, [177; 1033]); (Sum, [1044; 1045]); (Choose (Less 0 1), [1046; 182; 182; 1046]); (Product, [1038; 998]);
(Quotient, [177; 1048]); (Choose (Less 0 1), [1049; 182; 182; 1038]); (Product, [1041; 1038]); (Product, [1051; 1050]);
(Literal (0) (0), []); (Product, [1053; 490]); (Product, [182; 491]); (Difference, [1054; 1055]); (Product, [177; 492]);
(Difference, [1056; 1057]); (Choose (Less 0 1), [1052; 1058; 182; 1038]); (Product, [1047; 1047]); (Product, [1060;
998]); (Product, [1061; 1050]); (Power, [1062; 38]); (Choose (Same 0 1), [1059; 1026; 31; 241]); (Choose (Same 0 1),
[1063; 1027; 31; 241]); (Product, [241; 1007]); (Product, [182; 490]); (Sum, [1067; 1055]); (Sum, [1068; 1057]);
(Product, [1066; 1069]); (Product, [1000; 490]); (Difference, [1070; 1071]); (Product, [1001; 491])].
Definition from_900 : list (operation * list N) := [(Difference, [1072; 1073]); (Product, [1002; 492]); (Difference,
[1074; 1075]); (Choose (Less 0 1), [1076; 182; 182; 1076]); (Power, [1077; 38]); (Choose (Same 0 1), [1007; 1064; 31;
239]); (Choose (Same 0 1), [1078; 1065; 31; 239]); (Choose (Same 0 1), [1007; 1079; 31; 358]); (Choose (Same 0 1), [182;
1080; 31; 358]); (Choose (Less 0 1), [1024; 182; 182; 1007]); (Power, [1083; 38]); (Choose (Same 0 1), [1007; 1081; 31;
371]); (Choose (Same 0 1), [1084; 1082; 31; 371]); (Choose (Same 0 1), [1007; 1085; 31; 382]); (Choose (Same 0 1), [182;
1086; 31; 382]); (Choose (Less 0 1), [1062; 182; 182; 1059]); (Power, [1089; 38]); (Choose (Same 0 1), [1059; 1087; 31;
400]); (Choose (Same 0 1), [1090; 1088; 31; 400]); (Choose (Less 0 1), [1091; 182; 182; 1091]); (Product, [10; 1093]);
(Product, [11; 1092]); (Product, [549; 1094]); (Sum, [1096; 1095]); (Product, [52; 1097]); (Sum, [1098; 42]); (Product,
[53; 1097]); (Sum, [43; 1100]); (Product, [550; 1094]); (Sum, [1102; 1095]); (Product, [54; 1103]); (Sum, [44; 1104]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1099; 42; 244; 239; 0; 182; 995; 55]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1101; 43; 244; 239; 0; 182; 995; 55]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1105; 44; 244; 239; 0; 182; 995; 55]);
(Choose (Less 0 1), [1106; 182; 182; 1106]); (Choose (Less 0 1), [1109; 177; 1109; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [1110; 928; 244; 239; 0]); (Choose (Less 0 1), [1107; 182; 182; 1107]); (Choose (Less 0 1), [1112; 177; 1112;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [1113; 931; 244; 239; 0]); (Choose (Less 0 1), [1108; 182; 182; 1108]);
(Choose (Less 0 1), [1115; 177; 1115; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1116; 934; 244; 239; 0]); (Product,
[452; 615]); (Product, [454; 616]); (Sum, [1118; 1119]); (Product, [455; 617]); (Sum, [1120; 1121]); (Choose (Both (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [754; 42; 244; 177; 0; 182; 648; 55;
1122])].
Definition from_950 : list (operation * list N) := [(Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3
4))) (Less 3 5)) (Less 3 6)), [758; 43; 244; 177; 0; 182; 648; 55; 1122]); (Choose (Both (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [762; 44; 244; 177; 0; 182; 648; 55; 1122]); (Choose (Less 0 1),
[1123; 182; 182; 1123]); (Choose (Less 0 1), [1126; 177; 1126; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1127; 182;
244; 177; 0]); (Choose (Less 0 1), [1124; 182; 182; 1124]); (Choose (Less 0 1), [1129; 177; 1129; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [1130; 182; 244; 177; 0]); (Choose (Less 0 1), [1125; 182; 182; 1125]); (Choose (Less 0 1),
[1132; 177; 1132; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1133; 182; 244; 177; 0]); (Choose (Both (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [914; 42; 244; 241; 0; 182; 808; 55; 856]);
(Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [918; 43; 244; 241; 0;
182; 808; 55; 856]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)),
[922; 44; 244; 241; 0; 182; 808; 55; 856]); (Choose (Less 0 1), [1135; 182; 182; 1135]); (Choose (Less 0 1), [1138; 177;
1138; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1139; 1128; 244; 241; 0]); (Choose (Less 0 1), [1136; 182; 182;
1136]); (Choose (Less 0 1), [1141; 177; 1141; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1142; 1131; 244; 241; 0]);
(Choose (Less 0 1), [1137; 182; 182; 1137]); (Choose (Less 0 1), [1144; 177; 1144; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [1145; 1134; 244; 241; 0]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5))
(Less 3 6)), [1099; 42; 244; 239; 0; 182; 995; 55; 1041]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)) (Less 3 6)), [1101; 43; 244; 239; 0; 182; 995; 55; 1041]); (Choose (Both (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1105; 44; 244; 239; 0; 182; 995; 55; 1041]); (Choose
(Less 0 1), [1147; 182; 182; 1147]); (Choose (Less 0 1), [1150; 177; 1150; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[1151; 1140; 244; 239; 0]); (Choose (Less 0 1), [1148; 182; 182; 1148]); (Choose (Less 0 1), [1153; 177; 1153; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [1154; 1143; 244; 239; 0]); (Choose (Less 0 1), [1149; 182; 182; 1149]); (Choose
(Less 0 1), [1156; 177; 1156; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1157; 1146; 244; 239; 0]); (Product, [612;
615]); (Product, [613; 616]); (Sum, [1159; 1160]); (Product, [614; 617]); (Sum, [1161; 1162]); (Product, [612; 682]);
(Product, [613; 684]); (Sum, [1164; 1165]); (Product, [614; 686]); (Sum, [1166; 1167]); (Choose (Less 0 1), [1168; 182;
182; 1168]); (Product, [1163; 691]); (Product, [1170; 705]); (Negative, [612]); (Product, [1172; 490])].
Definition from_1000 : list (operation * list N) := [(Product, [613; 491]); (Difference, [1173; 1174]); (Product, [614;
492]); (Difference, [1175; 1176]); (Choose (Less 0 1), [1171; 1177; 182; 691]); (Product, [1169; 1169]); (Product,
[1179; 651]); (Product, [1180; 705]); (Product, [1181; 1181]); (Product, [1182; 1182]); (Product, [1183; 1183]);
(Product, [1184; 1184]); (Choose (Less 0 1), [1178; 182; 182; 1178]); (Product, [10; 1186]); (Product, [11; 1185]);
(Product, [12; 1187]); (Sum, [1189; 1188]); (Product, [52; 1190]); (Sum, [1191; 42]); (Product, [13; 1187]); (Sum,
[1193; 1188]); (Product, [53; 1194]); (Sum, [43; 1195]); (Product, [14; 1187]); (Sum, [1197; 1188]); (Product, [54;
1198]); (Sum, [44; 1199]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1192; 42;
244; 177; 0; 182; 648; 55]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1196; 43;
244; 177; 0; 182; 648; 55]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1200; 44;
244; 177; 0; 182; 648; 55]); (Choose (Less 0 1), [1201; 182; 182; 1201]); (Choose (Less 0 1), [1204; 177; 1204; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [1205; 182; 244; 177; 0]); (Choose (Less 0 1), [1202; 182; 182; 1202]); (Choose
(Less 0 1), [1207; 177; 1207; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1208; 182; 244; 177; 0]); (Choose (Less 0
1), [1203; 182; 182; 1203]); (Choose (Less 0 1), [1210; 177; 1210; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1211;
182; 244; 177; 0]); (Product, [877; 877]); (Product, [1213; 1213]); (Product, [1214; 1214]); (Product, [1215; 1215]);
(Choose (Less 0 1), [874; 182; 182; 874]); (Product, [10; 1217]); (Product, [11; 1216]); (Product, [15; 1218]); (Sum,
[1220; 1219]); (Product, [52; 1221]); (Sum, [1222; 42])].
Definition from_1050 : list (operation * list N) := [(Product, [16; 1218]); (Sum, [1224; 1219]); (Product, [53; 1225]);
(Sum, [43; 1226]); (Product, [17; 1218]); (Sum, [1228; 1219]); (Product, [54; 1229]); (Sum, [44; 1230]); (Choose (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1223; 42; 244; 241; 0; 182; 808; 55]); (Choose (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1227; 43; 244; 241; 0; 182; 808; 55]); (Choose (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1231; 44; 244; 241; 0; 182; 808; 55]); (Choose (Less
0 1), [1232; 182; 182; 1232]); (Choose (Less 0 1), [1235; 177; 1235; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1236;
1206; 244; 241; 0]); (Choose (Less 0 1), [1233; 182; 182; 1233]); (Choose (Less 0 1), [1238; 177; 1238; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [1239; 1209; 244; 241; 0]); (Choose (Less 0 1), [1234; 182; 182; 1234]); (Choose (Less 0
1), [1241; 177; 1241; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1242; 1212; 244; 241; 0]); (Product, [1062; 1062]);
(Product, [1244; 1244]); (Product, [1245; 1245]); (Product, [1246; 1246]); (Choose (Less 0 1), [1059; 182; 182; 1059]);
(Product, [10; 1248]); (Product, [11; 1247]); (Product, [549; 1249]); (Sum, [1251; 1250]); (Product, [52; 1252]); (Sum,
[1253; 42]); (Product, [53; 1252]); (Sum, [43; 1255]); (Product, [550; 1249]); (Sum, [1257; 1250]); (Product, [54;
1258]); (Sum, [44; 1259]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1254; 42;
244; 239; 0; 182; 995; 55]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1256; 43;
244; 239; 0; 182; 995; 55]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1260; 44;
244; 239; 0; 182; 995; 55]); (Choose (Less 0 1), [1261; 182; 182; 1261]); (Choose (Less 0 1), [1264; 177; 1264; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [1265; 1237; 244; 239; 0]); (Choose (Less 0 1), [1262; 182; 182; 1262]); (Choose
(Less 0 1), [1267; 177; 1267; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1268; 1240; 244; 239; 0]); (Choose (Less 0
1), [1263; 182; 182; 1263]); (Choose (Less 0 1), [1270; 177; 1270; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1271;
1243; 244; 239; 0]); (Difference, [74; 452])].
Definition from_1100 : list (operation * list N) := [(Difference, [75; 454]); (Difference, [76; 455]); (Product, [1273;
1273]); (Product, [1274; 1274]); (Sum, [1276; 1277]); (Product, [1275; 1275]); (Sum, [1278; 1279]); (Product, [618;
1273]); (Product, [619; 1274]); (Sum, [1281; 1282]); (Product, [620; 1275]); (Sum, [1283; 1284]); (Product, [207;
1280]); (Product, [619; 1273]); (Product, [618; 1274]); (Difference, [1287; 1288]); (Product, [1289; 1289]);
(Difference, [1286; 1290]); (Product, [618; 1275]); (Product, [620; 1273]); (Difference, [1292; 1293]); (Product, [1294;
1294]); (Difference, [1291; 1295]); (Product, [620; 1274]); (Product, [619; 1275]); (Difference, [1297; 1298]);
(Product, [1299; 1299]); (Difference, [1296; 1300]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177;
182; 1285; 1280; 182; 1301]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most
2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 177; 0; 91; 92; 93; 1; 94; 182; 1302]); (Sum, [650;
81]); (Choose (Less 0 1), [1304; 650; 182; 1303]); (Root, [1280]); (Quotient, [177; 1306]); (Product, [1307; 1273]);
(Product, [1307; 1274]); (Product, [1307; 1275]); (Product, [484; 1308]); (Product, [485; 1309]); (Sum, [1311; 1312]);
(Product, [486; 1310]); (Sum, [1313; 1314]); (Sum, [1308; 490]); (Sum, [1309; 491]); (Sum, [1310; 492]); (Product,
[1316; 1316]); (Product, [1317; 1317]); (Sum, [1319; 1320]); (Product, [1318; 1318]); (Sum, [1321; 1322])].
Definition from_1150 : list (operation * list N) := [(Root, [1323]); (Product, [484; 1316]); (Product, [485; 1317]);
(Sum, [1325; 1326]); (Product, [486; 1318]); (Sum, [1327; 1328]); (Quotient, [1329; 1324]); (Choose (Less 0 1), [1330;
182; 182; 1330]); (Choose (Less 0 1), [1331; 182; 182; 1324]); (Power, [1332; 38]); (Choose (Same 0 1), [1315; 1315; 31;
177]); (Choose (Same 0 1), [182; 1333; 31; 177]); (Product, [1306; 490]); (Sum, [1336; 1273]); (Product, [1306; 491]);
(Sum, [1338; 1274]); (Product, [1306; 492]); (Sum, [1340; 1275]); (Product, [1337; 1337]); (Product, [1339; 1339]);
(Sum, [1342; 1343]); (Product, [1341; 1341]); (Sum, [1344; 1345]); (Product, [484; 1273]); (Product, [485; 1274]); (Sum,
[1347; 1348]); (Product, [486; 1275]); (Sum, [1349; 1350]); (Product, [484; 1337]); (Product, [485; 1339]); (Sum, [1352;
1353]); (Product, [486; 1341]); (Sum, [1354; 1355]); (Choose (Less 0 1), [1356; 182; 182; 1356]); (Product, [1346;
1306]); (Quotient, [177; 1358]); (Choose (Less 0 1), [1359; 182; 182; 1346]); (Product, [1351; 1346]); (Product, [1361;
1360]); (Choose (Less 0 1), [1362; 713; 182; 1346]); (Product, [1357; 1357]); (Product, [1364; 1306]); (Product, [1365;
1360]); (Power, [1366; 38]); (Choose (Same 0 1), [1363; 1334; 31; 241]); (Choose (Same 0 1), [1367; 1335; 31; 241]);
(Product, [241; 1315]); (Product, [1370; 724]); (Product, [1308; 490]); (Difference, [1371; 1372])].
Definition from_1200 : list (operation * list N) := [(Product, [1309; 491]); (Difference, [1373; 1374]); (Product,
[1310; 492]); (Difference, [1375; 1376]); (Choose (Less 0 1), [1377; 182; 182; 1377]); (Power, [1378; 38]); (Choose
(Same 0 1), [1315; 1368; 31; 239]); (Choose (Same 0 1), [1379; 1369; 31; 239]); (Choose (Same 0 1), [1315; 1380; 31;
358]); (Choose (Same 0 1), [182; 1381; 31; 358]); (Choose (Less 0 1), [1332; 182; 182; 1315]); (Power, [1384; 38]);
(Choose (Same 0 1), [1315; 1382; 31; 371]); (Choose (Same 0 1), [1385; 1383; 31; 371]); (Choose (Same 0 1), [1315; 1386;
31; 382]); (Choose (Same 0 1), [182; 1387; 31; 382]); (Choose (Less 0 1), [1366; 182; 182; 1363]); (Power, [1390; 38]);
(Choose (Same 0 1), [1363; 1388; 31; 400]); (Choose (Same 0 1), [1391; 1389; 31; 400]); (Choose (Less 0 1), [1392; 182;
182; 1392]); (Product, [10; 1394]); (Product, [11; 1393]); (Product, [12; 1395]); (Sum, [1397; 1396]); (Product, [77;
1398]); (Sum, [1399; 763]); (Product, [13; 1395]); (Sum, [1401; 1396]); (Product, [78; 1402]); (Sum, [764; 1403]);
(Product, [14; 1395]); (Sum, [1405; 1396]); (Product, [79; 1406]); (Sum, [765; 1407]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1400; 763; 244; 177; 0; 182; 1303; 80]); (Choose (Both (Both (Both (Same
0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1404; 764; 244; 177; 0; 182; 1303; 80]); (Choose (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1408; 765; 244; 177; 0; 182; 1303; 80]); (Choose (Less 0 1),
[1409; 182; 182; 1409]); (Choose (Less 0 1), [1412; 177; 1412; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1413; 182;
244; 177; 0]); (Choose (Less 0 1), [1410; 182; 182; 1410]); (Choose (Less 0 1), [1415; 177; 1415; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [1416; 182; 244; 177; 0]); (Choose (Less 0 1), [1411; 182; 182; 1411]); (Choose (Less 0 1),
[1418; 177; 1418; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1419; 182; 244; 177; 0]); (Sum, [1305; 56]); (Choose
(Less 0 1), [1421; 1305; 182; 808]); (Difference, [74; 531])].
Definition from_1250 : list (operation * list N) := [(Difference, [75; 533]); (Difference, [76; 535]); (Product, [1423;
1423]); (Product, [1424; 1424]); (Sum, [1426; 1427]); (Product, [1425; 1425]); (Sum, [1428; 1429]); (Product, [778;
1423]); (Product, [779; 1424]); (Sum, [1431; 1432]); (Product, [780; 1425]); (Sum, [1433; 1434]); (Product, [254;
1430]); (Product, [779; 1423]); (Product, [778; 1424]); (Difference, [1437; 1438]); (Product, [1439; 1439]);
(Difference, [1436; 1440]); (Product, [778; 1425]); (Product, [780; 1423]); (Difference, [1442; 1443]); (Product, [1444;
1444]); (Difference, [1441; 1445]); (Product, [780; 1424]); (Product, [779; 1425]); (Difference, [1447; 1448]);
(Product, [1449; 1449]); (Difference, [1446; 1450]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177;
182; 1435; 1430; 182; 1451]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most
2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 241; 0; 95; 96; 97; 1; 98; 182; 1452]); (Sum, [1422;
81]); (Choose (Less 0 1), [1454; 1422; 182; 1453]); (Root, [1430]); (Quotient, [177; 1456]); (Product, [1457; 1423]);
(Product, [1457; 1424]); (Product, [1457; 1425]); (Product, [527; 1458]); (Product, [528; 1459]); (Sum, [1461; 1462]);
(Product, [529; 1460]); (Sum, [1463; 1464]); (Sum, [1458; 490]); (Sum, [1459; 491]); (Sum, [1460; 492]); (Product,
[1466; 1466]); (Product, [1467; 1467]); (Sum, [1469; 1470]); (Product, [1468; 1468]); (Sum, [1471; 1472])].
Definition from_1300 : list (operation * list N) := [(Root, [1473]); (Product, [527; 1466]); (Product, [528; 1467]);
(Sum, [1475; 1476]); (Product, [529; 1468]); (Sum, [1477; 1478]); (Quotient, [1479; 1474]); (Choose (Less 0 1), [1480;
182; 182; 1480]); (Choose (Less 0 1), [1481; 182; 182; 1474]); (Power, [1482; 38]); (Choose (Same 0 1), [1465; 1465; 31;
177]); (Choose (Same 0 1), [182; 1483; 31; 177]); (Product, [1456; 490]); (Sum, [1486; 1423]); (Product, [1456; 491]);
(Sum, [1488; 1424]); (Product, [1456; 492]); (Sum, [1490; 1425]); (Product, [1487; 1487]); (Product, [1489; 1489]);
(Sum, [1492; 1493]); (Product, [1491; 1491]); (Sum, [1494; 1495]); (Product, [527; 1423]); (Product, [528; 1424]); (Sum,
[1497; 1498]); (Product, [529; 1425]); (Sum, [1499; 1500]); (Product, [527; 1487]); (Product, [528; 1489]); (Sum, [1502;
1503]); (Product, [529; 1491]); (Sum, [1504; 1505]); (Choose (Less 0 1), [1506; 182; 182; 1506]); (Product, [1496;
1456]); (Quotient, [177; 1508]); (Choose (Less 0 1), [1509; 182; 182; 1496]); (Product, [1501; 1496]); (Product, [1511;
1510]); (Choose (Less 0 1), [1512; 873; 182; 1496]); (Product, [1507; 1507]); (Product, [1514; 1456]); (Product, [1515;
1510]); (Power, [1516; 38]); (Choose (Same 0 1), [1513; 1484; 31; 241]); (Choose (Same 0 1), [1517; 1485; 31; 241]);
(Product, [241; 1465]); (Product, [1520; 884]); (Product, [1458; 490]); (Difference, [1521; 1522])].
Definition from_1350 : list (operation * list N) := [(Product, [1459; 491]); (Difference, [1523; 1524]); (Product,
[1460; 492]); (Difference, [1525; 1526]); (Choose (Less 0 1), [1527; 182; 182; 1527]); (Power, [1528; 38]); (Choose
(Same 0 1), [1465; 1518; 31; 239]); (Choose (Same 0 1), [1529; 1519; 31; 239]); (Choose (Same 0 1), [1465; 1530; 31;
358]); (Choose (Same 0 1), [182; 1531; 31; 358]); (Choose (Less 0 1), [1482; 182; 182; 1465]); (Power, [1534; 38]);
(Choose (Same 0 1), [1465; 1532; 31; 371]); (Choose (Same 0 1), [1535; 1533; 31; 371]); (Choose (Same 0 1), [1465; 1536;
31; 382]); (Choose (Same 0 1), [182; 1537; 31; 382]); (Choose (Less 0 1), [1516; 182; 182; 1513]); (Power, [1540; 38]);
(Choose (Same 0 1), [1513; 1538; 31; 400]); (Choose (Same 0 1), [1541; 1539; 31; 400]); (Choose (Less 0 1), [1542; 182;
182; 1542]); (Product, [10; 1544]); (Product, [11; 1543]); (Product, [15; 1545]); (Sum, [1547; 1546]); (Product, [77;
1548]); (Sum, [1549; 923]); (Product, [16; 1545]); (Sum, [1551; 1546]); (Product, [78; 1552]); (Sum, [924; 1553]);
(Product, [17; 1545]); (Sum, [1555; 1546]); (Product, [79; 1556]); (Sum, [925; 1557]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1550; 923; 244; 241; 0; 182; 1453; 80]); (Choose (Both (Both (Both (Same
0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1554; 924; 244; 241; 0; 182; 1453; 80]); (Choose (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1558; 925; 244; 241; 0; 182; 1453; 80]); (Choose (Less 0 1),
[1559; 182; 182; 1559]); (Choose (Less 0 1), [1562; 177; 1562; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1563; 1414;
244; 241; 0]); (Choose (Less 0 1), [1560; 182; 182; 1560]); (Choose (Less 0 1), [1565; 177; 1565; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [1566; 1417; 244; 241; 0]); (Choose (Less 0 1), [1561; 182; 182; 1561]); (Choose (Less 0 1),
[1568; 177; 1568; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1569; 1420; 244; 241; 0]); (Sum, [1455; 546]); (Choose
(Both (Both (Same 0 1) (Same 2 2)) (Less 3 4)), [1571; 1455; 244; 239; 0; 182; 545]); (Sum, [1572; 56])].
Definition from_1400 : list (operation * list N) := [(Choose (Less 0 1), [1573; 1572; 182; 995]); (Difference, [74; 0]);
(Difference, [75; 1]); (Difference, [76; 182]); (Product, [1575; 1575]); (Product, [1576; 1576]); (Sum, [1578; 1579]);
(Product, [1577; 1577]); (Sum, [1580; 1581]); (Product, [940; 1575]); (Product, [941; 1576]); (Sum, [1583; 1584]);
(Product, [182; 1577]); (Sum, [1585; 1586]); (Product, [254; 1582]); (Product, [941; 1575]); (Product, [940; 1576]);
(Difference, [1589; 1590]); (Product, [1591; 1591]); (Difference, [1588; 1592]); (Product, [940; 1577]); (Product, [182;
1575]); (Difference, [1594; 1595]); (Product, [1596; 1596]); (Difference, [1593; 1597]); (Product, [182; 1576]);
(Product, [941; 1577]); (Difference, [1599; 1600]); (Product, [1601; 1601]); (Difference, [1598; 1602]); (Choose (Both
(Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 1587; 1582; 182; 1603]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244;
239; 0; 83; 84; 85; 1; 86; 182; 1604]); (Product, [970; 1575]); (Product, [971; 1576]); (Sum, [1606; 1607]); (Product,
[972; 1577]); (Sum, [1608; 1609]); (Product, [207; 1582]); (Product, [971; 1575]); (Product, [970; 1576]); (Difference,
[1612; 1613]); (Product, [1614; 1614]); (Difference, [1611; 1615]); (Product, [970; 1577]); (Product, [972; 1575]);
(Difference, [1617; 1618]); (Product, [1619; 1619]); (Difference, [1616; 1620]); (Product, [972; 1576]); (Product, [971;
1577])].
Definition from_1450 : list (operation * list N) := [(Difference, [1622; 1623]); (Product, [1624; 1624]); (Difference,
[1621; 1625]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 1610; 1582; 182; 1626]); (Choose
(Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7)))
(Less 8 9)), [177; 1605; 244; 239; 0; 87; 88; 89; 1; 90; 182; 1627]); (Sum, [1574; 81]); (Choose (Less 0 1), [1629;
1574; 182; 1628]); (Root, [1582]); (Quotient, [177; 1631]); (Product, [1632; 1575]); (Product, [1632; 1576]); (Product,
[1632; 1577]); (Product, [182; 1633]); (Product, [182; 1634]); (Sum, [1636; 1637]); (Product, [177; 1635]); (Sum, [1638;
1639]); (Sum, [1633; 490]); (Sum, [1634; 491]); (Sum, [1635; 492]); (Product, [1641; 1641]); (Product, [1642; 1642]);
(Sum, [1644; 1645]); (Product, [1643; 1643]); (Sum, [1646; 1647]); (Root, [1648]); (Product, [182; 1641]); (Product,
[182; 1642]); (Sum, [1650; 1651]); (Product, [177; 1643]); (Sum, [1652; 1653]); (Quotient, [1654; 1649]); (Choose (Less
0 1), [1655; 182; 182; 1655]); (Choose (Less 0 1), [1656; 182; 182; 1649]); (Power, [1657; 38]); (Choose (Same 0 1),
[1640; 1640; 31; 177]); (Choose (Same 0 1), [182; 1658; 31; 177]); (Product, [1631; 490]); (Sum, [1661; 1575]);
(Product, [1631; 491]); (Sum, [1663; 1576]); (Product, [1631; 492]); (Sum, [1665; 1577]); (Product, [1662; 1662]);
(Product, [1664; 1664]); (Sum, [1667; 1668]); (Product, [1666; 1666]); (Sum, [1669; 1670]); (Sum, [1595; 1599]);
(Product, [177; 1577])].
Definition from_1500 : list (operation * list N) := [(Sum, [1672; 1673]); (Product, [182; 1662]); (Product, [182;
1664]); (Sum, [1675; 1676]); (Product, [177; 1666]); (Sum, [1677; 1678]); (Choose (Less 0 1), [1679; 182; 182; 1679]);
(Product, [1671; 1631]); (Quotient, [177; 1681]); (Choose (Less 0 1), [1682; 182; 182; 1671]); (Product, [1674; 1671]);
(Product, [1684; 1683]); (Choose (Less 0 1), [1685; 1058; 182; 1671]); (Product, [1680; 1680]); (Product, [1687; 1631]);
(Product, [1688; 1683]); (Power, [1689; 38]); (Choose (Same 0 1), [1686; 1659; 31; 241]); (Choose (Same 0 1), [1690;
1660; 31; 241]); (Product, [241; 1640]); (Product, [1693; 1069]); (Product, [1633; 490]); (Difference, [1694; 1695]);
(Product, [1634; 491]); (Difference, [1696; 1697]); (Product, [1635; 492]); (Difference, [1698; 1699]); (Choose (Less 0
1), [1700; 182; 182; 1700]); (Power, [1701; 38]); (Choose (Same 0 1), [1640; 1691; 31; 239]); (Choose (Same 0 1), [1702;
1692; 31; 239]); (Choose (Same 0 1), [1640; 1703; 31; 358]); (Choose (Same 0 1), [182; 1704; 31; 358]); (Choose (Less 0
1), [1657; 182; 182; 1640]); (Power, [1707; 38]); (Choose (Same 0 1), [1640; 1705; 31; 371]); (Choose (Same 0 1), [1708;
1706; 31; 371]); (Choose (Same 0 1), [1640; 1709; 31; 382]); (Choose (Same 0 1), [182; 1710; 31; 382]); (Choose (Less 0
1), [1689; 182; 182; 1686]); (Power, [1713; 38]); (Choose (Same 0 1), [1686; 1711; 31; 400]); (Choose (Same 0 1), [1714;
1712; 31; 400]); (Choose (Less 0 1), [1715; 182; 182; 1715]); (Product, [10; 1717]); (Product, [11; 1716]); (Product,
[549; 1718]); (Sum, [1720; 1719]); (Product, [77; 1721]); (Sum, [1722; 1106])].
Definition from_1550 : list (operation * list N) := [(Product, [78; 1721]); (Sum, [1107; 1724]); (Product, [550; 1718]);
(Sum, [1726; 1719]); (Product, [79; 1727]); (Sum, [1108; 1728]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)), [1723; 1106; 244; 239; 0; 182; 1628; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)), [1725; 1107; 244; 239; 0; 182; 1628; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2
2)) (Not (Less 3 4))) (Less 3 5)), [1729; 1108; 244; 239; 0; 182; 1628; 80]); (Choose (Less 0 1), [1730; 182; 182;
1730]); (Choose (Less 0 1), [1733; 177; 1733; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1734; 1564; 244; 239; 0]);
(Choose (Less 0 1), [1731; 182; 182; 1731]); (Choose (Less 0 1), [1736; 177; 1736; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [1737; 1567; 244; 239; 0]); (Choose (Less 0 1), [1732; 182; 182; 1732]); (Choose (Less 0 1), [1739; 177; 1739;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [1740; 1570; 244; 239; 0]); (Product, [452; 1273]); (Product, [454; 1274]);
(Sum, [1742; 1743]); (Product, [455; 1275]); (Sum, [1744; 1745]); (Sum, [1399; 1123]); (Sum, [1124; 1403]); (Sum, [1125;
1407]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1747; 1123;
244; 177; 0; 182; 1303; 80; 1746]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5))
(Less 3 6)), [1748; 1124; 244; 177; 0; 182; 1303; 80; 1746]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1749; 1125; 244; 177; 0; 182; 1303; 80; 1746]); (Choose (Less 0 1), [1750;
182; 182; 1750]); (Choose (Less 0 1), [1753; 177; 1753; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1754; 182; 244;
177; 0]); (Choose (Less 0 1), [1751; 182; 182; 1751]); (Choose (Less 0 1), [1756; 177; 1756; 177]); (Choose (Both (Same
0 1) (Same 2 2)), [1757; 182; 244; 177; 0]); (Choose (Less 0 1), [1752; 182; 182; 1752]); (Choose (Less 0 1), [1759;
177; 1759; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1760; 182; 244; 177; 0]); (Sum, [1549; 1135]); (Sum, [1136;
1553]); (Sum, [1137; 1557]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less
3 6)), [1762; 1135; 244; 241; 0; 182; 1453; 80; 1501]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)) (Less 3 6)), [1763; 1136; 244; 241; 0; 182; 1453; 80; 1501]); (Choose (Both (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1764; 1137; 244; 241; 0; 182; 1453; 80; 1501]);
(Choose (Less 0 1), [1765; 182; 182; 1765]); (Choose (Less 0 1), [1768; 177; 1768; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [1769; 1755; 244; 241; 0]); (Choose (Less 0 1), [1766; 182; 182; 1766]); (Choose (Less 0 1), [1771; 177; 1771;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [1772; 1758; 244; 241; 0])].
Definition from_1600 : list (operation * list N) := [(Choose (Less 0 1), [1767; 182; 182; 1767]); (Choose (Less 0 1),
[1774; 177; 1774; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1775; 1761; 244; 241; 0]); (Sum, [1722; 1147]); (Sum,
[1148; 1724]); (Sum, [1149; 1728]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5))
(Less 3 6)), [1777; 1147; 244; 239; 0; 182; 1628; 80; 1674]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1778; 1148; 244; 239; 0; 182; 1628; 80; 1674]); (Choose (Both (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [1779; 1149; 244; 239; 0; 182; 1628; 80; 1674]);
(Choose (Less 0 1), [1780; 182; 182; 1780]); (Choose (Less 0 1), [1783; 177; 1783; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [1784; 1770; 244; 239; 0]); (Choose (Less 0 1), [1781; 182; 182; 1781]); (Choose (Less 0 1), [1786; 177; 1786;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [1787; 1773; 244; 239; 0]); (Choose (Less 0 1), [1782; 182; 182; 1782]);
(Choose (Less 0 1), [1789; 177; 1789; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1790; 1776; 244; 239; 0]); (Product,
[612; 1273]); (Product, [613; 1274]); (Sum, [1792; 1793]); (Product, [614; 1275]); (Sum, [1794; 1795]); (Product, [612;
1337]); (Product, [613; 1339]); (Sum, [1797; 1798]); (Product, [614; 1341]); (Sum, [1799; 1800]); (Choose (Less 0 1),
[1801; 182; 182; 1801]); (Product, [1796; 1346]); (Product, [1803; 1360]); (Choose (Less 0 1), [1804; 1177; 182; 1346]);
(Product, [1802; 1802]); (Product, [1806; 1306]); (Product, [1807; 1360]); (Product, [1808; 1808]); (Product, [1809;
1809]); (Product, [1810; 1810]); (Product, [1811; 1811]); (Choose (Less 0 1), [1805; 182; 182; 1805]); (Product, [10;
1813]); (Product, [11; 1812]); (Product, [12; 1814]); (Sum, [1816; 1815]); (Product, [77; 1817]); (Sum, [1818; 1201]);
(Product, [13; 1814]); (Sum, [1820; 1815]); (Product, [78; 1821]); (Sum, [1202; 1822])].
Definition from_1650 : list (operation * list N) := [(Product, [14; 1814]); (Sum, [1824; 1815]); (Product, [79; 1825]);
(Sum, [1203; 1826]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1819; 1201; 244;
177; 0; 182; 1303; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1823; 1202;
244; 177; 0; 182; 1303; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1827;
1203; 244; 177; 0; 182; 1303; 80]); (Choose (Less 0 1), [1828; 182; 182; 1828]); (Choose (Less 0 1), [1831; 177; 1831;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [1832; 182; 244; 177; 0]); (Choose (Less 0 1), [1829; 182; 182; 1829]);
(Choose (Less 0 1), [1834; 177; 1834; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1835; 182; 244; 177; 0]); (Choose
(Less 0 1), [1830; 182; 182; 1830]); (Choose (Less 0 1), [1837; 177; 1837; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[1838; 182; 244; 177; 0]); (Product, [1516; 1516]); (Product, [1840; 1840]); (Product, [1841; 1841]); (Product, [1842;
1842]); (Choose (Less 0 1), [1513; 182; 182; 1513]); (Product, [10; 1844]); (Product, [11; 1843]); (Product, [15;
1845]); (Sum, [1847; 1846]); (Product, [77; 1848]); (Sum, [1849; 1232]); (Product, [16; 1845]); (Sum, [1851; 1846]);
(Product, [78; 1852]); (Sum, [1233; 1853]); (Product, [17; 1845]); (Sum, [1855; 1846]); (Product, [79; 1856]); (Sum,
[1234; 1857]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1850; 1232; 244; 241; 0;
182; 1453; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1854; 1233; 244; 241;
0; 182; 1453; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [1858; 1234; 244;
241; 0; 182; 1453; 80]); (Choose (Less 0 1), [1859; 182; 182; 1859]); (Choose (Less 0 1), [1862; 177; 1862; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [1863; 1833; 244; 241; 0]); (Choose (Less 0 1), [1860; 182; 182; 1860]); (Choose
(Less 0 1), [1865; 177; 1865; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1866; 1836; 244; 241; 0]); (Choose (Less 0
1), [1861; 182; 182; 1861]); (Choose (Less 0 1), [1868; 177; 1868; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1869;
1839; 244; 241; 0]); (Product, [1689; 1689]); (Product, [1871; 1871]); (Product, [1872; 1872])].
Definition from_1700 : list (operation * list N) := [(Product, [1873; 1873]); (Choose (Less 0 1), [1686; 182; 182;
1686]); (Product, [10; 1875]); (Product, [11; 1874]); (Product, [549; 1876]); (Sum, [1878; 1877]); (Product, [77;
1879]); (Sum, [1880; 1261]); (Product, [78; 1879]); (Sum, [1262; 1882]); (Product, [550; 1876]); (Sum, [1884; 1877]);
(Product, [79; 1885]); (Sum, [1263; 1886]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)), [1881; 1261; 244; 239; 0; 182; 1628; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less
3 5)), [1883; 1262; 244; 239; 0; 182; 1628; 80]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4)))
(Less 3 5)), [1887; 1263; 244; 239; 0; 182; 1628; 80]); (Choose (Less 0 1), [1888; 182; 182; 1888]); (Choose (Less 0 1),
[1891; 177; 1891; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1892; 1864; 244; 239; 0]); (Choose (Less 0 1), [1889;
182; 182; 1889]); (Choose (Less 0 1), [1894; 177; 1894; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [1895; 1867; 244;
239; 0]); (Choose (Less 0 1), [1890; 182; 182; 1890]); (Choose (Less 0 1), [1897; 177; 1897; 177]); (Choose (Both (Same
0 1) (Same 2 2)), [1898; 1870; 244; 239; 0]); (Difference, [99; 452]); (Difference, [100; 454]); (Difference, [101;
455]); (Product, [1900; 1900]); (Product, [1901; 1901]); (Sum, [1903; 1904]); (Product, [1902; 1902]); (Sum, [1905;
1906]); (Product, [618; 1900]); (Product, [619; 1901]); (Sum, [1908; 1909]); (Product, [620; 1902]); (Sum, [1910;
1911]); (Product, [207; 1907]); (Product, [619; 1900]); (Product, [618; 1901]); (Difference, [1914; 1915]); (Product,
[1916; 1916]); (Difference, [1913; 1917]); (Product, [618; 1902]); (Product, [620; 1900]); (Difference, [1919; 1920]);
(Product, [1921; 1921]); (Difference, [1918; 1922])].
Definition from_1750 : list (operation * list N) := [(Product, [620; 1901]); (Product, [619; 1902]); (Difference, [1924;
1925]); (Product, [1926; 1926]); (Difference, [1923; 1927]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)),
[177; 182; 1912; 1907; 182; 1928]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2)
(At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 177; 0; 116; 117; 118; 1; 119; 182; 1929]);
(Sum, [1305; 106]); (Choose (Less 0 1), [1931; 1305; 182; 1930]); (Root, [1907]); (Quotient, [177; 1933]); (Product,
[1934; 1900]); (Product, [1934; 1901]); (Product, [1934; 1902]); (Product, [484; 1935]); (Product, [485; 1936]); (Sum,
[1938; 1939]); (Product, [486; 1937]); (Sum, [1940; 1941]); (Sum, [1935; 490]); (Sum, [1936; 491]); (Sum, [1937; 492]);
(Product, [1943; 1943]); (Product, [1944; 1944]); (Sum, [1946; 1947]); (Product, [1945; 1945]); (Sum, [1948; 1949]);
(Root, [1950]); (Product, [484; 1943]); (Product, [485; 1944]); (Sum, [1952; 1953]); (Product, [486; 1945]); (Sum,
[1954; 1955]); (Quotient, [1956; 1951]); (Choose (Less 0 1), [1957; 182; 182; 1957]); (Choose (Less 0 1), [1958; 182;
182; 1951]); (Power, [1959; 38]); (Choose (Same 0 1), [1942; 1942; 31; 177]); (Choose (Same 0 1), [182; 1960; 31; 177]);
(Product, [1933; 490]); (Sum, [1963; 1900]); (Product, [1933; 491]); (Sum, [1965; 1901]); (Product, [1933; 492]); (Sum,
[1967; 1902]); (Product, [1964; 1964]); (Product, [1966; 1966]); (Sum, [1969; 1970]); (Product, [1968; 1968]); (Sum,
[1971; 1972])].
Definition from_1800 : list (operation * list N) := [(Product, [484; 1900]); (Product, [485; 1901]); (Sum, [1974;
1975]); (Product, [486; 1902]); (Sum, [1976; 1977]); (Product, [484; 1964]); (Product, [485; 1966]); (Sum, [1979;
1980]); (Product, [486; 1968]); (Sum, [1981; 1982]); (Choose (Less 0 1), [1983; 182; 182; 1983]); (Product, [1973;
1933]); (Quotient, [177; 1985]); (Choose (Less 0 1), [1986; 182; 182; 1973]); (Product, [1978; 1973]); (Product, [1988;
1987]); (Choose (Less 0 1), [1989; 713; 182; 1973]); (Product, [1984; 1984]); (Product, [1991; 1933]); (Product, [1992;
1987]); (Power, [1993; 38]); (Choose (Same 0 1), [1990; 1961; 31; 241]); (Choose (Same 0 1), [1994; 1962; 31; 241]);
(Product, [241; 1942]); (Product, [1997; 724]); (Product, [1935; 490]); (Difference, [1998; 1999]); (Product, [1936;
491]); (Difference, [2000; 2001]); (Product, [1937; 492]); (Difference, [2002; 2003]); (Choose (Less 0 1), [2004; 182;
182; 2004]); (Power, [2005; 38]); (Choose (Same 0 1), [1942; 1995; 31; 239]); (Choose (Same 0 1), [2006; 1996; 31;
239]); (Choose (Same 0 1), [1942; 2007; 31; 358]); (Choose (Same 0 1), [182; 2008; 31; 358]); (Choose (Less 0 1), [1959;
182; 182; 1942]); (Power, [2011; 38]); (Choose (Same 0 1), [1942; 2009; 31; 371]); (Choose (Same 0 1), [2012; 2010; 31;
371]); (Choose (Same 0 1), [1942; 2013; 31; 382]); (Choose (Same 0 1), [182; 2014; 31; 382]); (Choose (Less 0 1), [1993;
182; 182; 1990]); (Power, [2017; 38]); (Choose (Same 0 1), [1990; 2015; 31; 400]); (Choose (Same 0 1), [2018; 2016; 31;
400]); (Choose (Less 0 1), [2019; 182; 182; 2019]); (Product, [10; 2021]); (Product, [11; 2020])].
Definition from_1850 : list (operation * list N) := [(Product, [12; 2022]); (Sum, [2024; 2023]); (Product, [102; 2025]);
(Sum, [2026; 1409]); (Product, [13; 2022]); (Sum, [2028; 2023]); (Product, [103; 2029]); (Sum, [1410; 2030]); (Product,
[14; 2022]); (Sum, [2032; 2023]); (Product, [104; 2033]); (Sum, [1411; 2034]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2027; 1409; 244; 177; 0; 182; 1930; 105]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2031; 1410; 244; 177; 0; 182; 1930; 105]); (Choose (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2035; 1411; 244; 177; 0; 182; 1930; 105]); (Choose (Less 0 1),
[2036; 182; 182; 2036]); (Choose (Less 0 1), [2039; 177; 2039; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2040; 182;
244; 177; 0]); (Choose (Less 0 1), [2037; 182; 182; 2037]); (Choose (Less 0 1), [2042; 177; 2042; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [2043; 182; 244; 177; 0]); (Choose (Less 0 1), [2038; 182; 182; 2038]); (Choose (Less 0 1),
[2045; 177; 2045; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2046; 182; 244; 177; 0]); (Sum, [1932; 56]); (Choose
(Less 0 1), [2048; 1932; 182; 808]); (Sum, [2049; 81]); (Choose (Less 0 1), [2050; 2049; 182; 1453]); (Difference, [99;
531]); (Difference, [100; 533]); (Difference, [101; 535]); (Product, [2052; 2052]); (Product, [2053; 2053]); (Sum,
[2055; 2056]); (Product, [2054; 2054]); (Sum, [2057; 2058]); (Product, [778; 2052]); (Product, [779; 2053]); (Sum,
[2060; 2061]); (Product, [780; 2054]); (Sum, [2062; 2063]); (Product, [254; 2059]); (Product, [779; 2052]); (Product,
[778; 2053]); (Difference, [2066; 2067]); (Product, [2068; 2068]); (Difference, [2065; 2069]); (Product, [778; 2054]);
(Product, [780; 2052]); (Difference, [2071; 2072])].
Definition from_1900 : list (operation * list N) := [(Product, [2073; 2073]); (Difference, [2070; 2074]); (Product,
[780; 2053]); (Product, [779; 2054]); (Difference, [2076; 2077]); (Product, [2078; 2078]); (Difference, [2075; 2079]);
(Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 2064; 2059; 182; 2080]); (Choose (Both (Both (Both
(Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177;
182; 244; 241; 0; 120; 121; 122; 1; 123; 182; 2081]); (Sum, [2051; 106]); (Choose (Less 0 1), [2083; 2051; 182; 2082]);
(Root, [2059]); (Quotient, [177; 2085]); (Product, [2086; 2052]); (Product, [2086; 2053]); (Product, [2086; 2054]);
(Product, [527; 2087]); (Product, [528; 2088]); (Sum, [2090; 2091]); (Product, [529; 2089]); (Sum, [2092; 2093]); (Sum,
[2087; 490]); (Sum, [2088; 491]); (Sum, [2089; 492]); (Product, [2095; 2095]); (Product, [2096; 2096]); (Sum, [2098;
2099]); (Product, [2097; 2097]); (Sum, [2100; 2101]); (Root, [2102]); (Product, [527; 2095]); (Product, [528; 2096]);
(Sum, [2104; 2105]); (Product, [529; 2097]); (Sum, [2106; 2107]); (Quotient, [2108; 2103]); (Choose (Less 0 1), [2109;
182; 182; 2109]); (Choose (Less 0 1), [2110; 182; 182; 2103]); (Power, [2111; 38]); (Choose (Same 0 1), [2094; 2094; 31;
177]); (Choose (Same 0 1), [182; 2112; 31; 177]); (Product, [2085; 490]); (Sum, [2115; 2052]); (Product, [2085; 491]);
(Sum, [2117; 2053]); (Product, [2085; 492]); (Sum, [2119; 2054]); (Product, [2116; 2116]); (Product, [2118; 2118]);
(Sum, [2121; 2122])].
Definition from_1950 : list (operation * list N) := [(Product, [2120; 2120]); (Sum, [2123; 2124]); (Product, [527;
2052]); (Product, [528; 2053]); (Sum, [2126; 2127]); (Product, [529; 2054]); (Sum, [2128; 2129]); (Product, [527;
2116]); (Product, [528; 2118]); (Sum, [2131; 2132]); (Product, [529; 2120]); (Sum, [2133; 2134]); (Choose (Less 0 1),
[2135; 182; 182; 2135]); (Product, [2125; 2085]); (Quotient, [177; 2137]); (Choose (Less 0 1), [2138; 182; 182; 2125]);
(Product, [2130; 2125]); (Product, [2140; 2139]); (Choose (Less 0 1), [2141; 873; 182; 2125]); (Product, [2136; 2136]);
(Product, [2143; 2085]); (Product, [2144; 2139]); (Power, [2145; 38]); (Choose (Same 0 1), [2142; 2113; 31; 241]);
(Choose (Same 0 1), [2146; 2114; 31; 241]); (Product, [241; 2094]); (Product, [2149; 884]); (Product, [2087; 490]);
(Difference, [2150; 2151]); (Product, [2088; 491]); (Difference, [2152; 2153]); (Product, [2089; 492]); (Difference,
[2154; 2155]); (Choose (Less 0 1), [2156; 182; 182; 2156]); (Power, [2157; 38]); (Choose (Same 0 1), [2094; 2147; 31;
239]); (Choose (Same 0 1), [2158; 2148; 31; 239]); (Choose (Same 0 1), [2094; 2159; 31; 358]); (Choose (Same 0 1), [182;
2160; 31; 358]); (Choose (Less 0 1), [2111; 182; 182; 2094]); (Power, [2163; 38]); (Choose (Same 0 1), [2094; 2161; 31;
371]); (Choose (Same 0 1), [2164; 2162; 31; 371]); (Choose (Same 0 1), [2094; 2165; 31; 382]); (Choose (Same 0 1), [182;
2166; 31; 382]); (Choose (Less 0 1), [2145; 182; 182; 2142]); (Power, [2169; 38]); (Choose (Same 0 1), [2142; 2167; 31;
400]); (Choose (Same 0 1), [2170; 2168; 31; 400]); (Choose (Less 0 1), [2171; 182; 182; 2171])].
Definition from_2000 : list (operation * list N) := [(Product, [10; 2173]); (Product, [11; 2172]); (Product, [15;
2174]); (Sum, [2176; 2175]); (Product, [102; 2177]); (Sum, [2178; 1559]); (Product, [16; 2174]); (Sum, [2180; 2175]);
(Product, [103; 2181]); (Sum, [1560; 2182]); (Product, [17; 2174]); (Sum, [2184; 2175]); (Product, [104; 2185]); (Sum,
[1561; 2186]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2179; 1559; 244; 241; 0;
182; 2082; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2183; 1560; 244; 241;
0; 182; 2082; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2187; 1561; 244;
241; 0; 182; 2082; 105]); (Choose (Less 0 1), [2188; 182; 182; 2188]); (Choose (Less 0 1), [2191; 177; 2191; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [2192; 2041; 244; 241; 0]); (Choose (Less 0 1), [2189; 182; 182; 2189]); (Choose
(Less 0 1), [2194; 177; 2194; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2195; 2044; 244; 241; 0]); (Choose (Less 0
1), [2190; 182; 182; 2190]); (Choose (Less 0 1), [2197; 177; 2197; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2198;
2047; 244; 241; 0]); (Sum, [2084; 546]); (Choose (Both (Both (Same 0 1) (Same 2 2)) (Less 3 4)), [2200; 2084; 244; 239;
0; 182; 545]); (Sum, [2201; 56]); (Choose (Less 0 1), [2202; 2201; 182; 995]); (Sum, [2203; 81]); (Choose (Less 0 1),
[2204; 2203; 182; 1628]); (Difference, [99; 0]); (Difference, [100; 1]); (Difference, [101; 182]); (Product, [2206;
2206]); (Product, [2207; 2207]); (Sum, [2209; 2210]); (Product, [2208; 2208]); (Sum, [2211; 2212]); (Product, [940;
2206]); (Product, [941; 2207]); (Sum, [2214; 2215]); (Product, [182; 2208]); (Sum, [2216; 2217]); (Product, [254;
2213]); (Product, [941; 2206]); (Product, [940; 2207]); (Difference, [2220; 2221]); (Product, [2222; 2222])].
Definition from_2050 : list (operation * list N) := [(Difference, [2219; 2223]); (Product, [940; 2208]); (Product, [182;
2206]); (Difference, [2225; 2226]); (Product, [2227; 2227]); (Difference, [2224; 2228]); (Product, [182; 2207]);
(Product, [941; 2208]); (Difference, [2230; 2231]); (Product, [2232; 2232]); (Difference, [2229; 2233]); (Choose (Both
(Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 2218; 2213; 182; 2234]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244;
239; 0; 108; 109; 110; 1; 111; 182; 2235]); (Product, [970; 2206]); (Product, [971; 2207]); (Sum, [2237; 2238]);
(Product, [972; 2208]); (Sum, [2239; 2240]); (Product, [207; 2213]); (Product, [971; 2206]); (Product, [970; 2207]);
(Difference, [2243; 2244]); (Product, [2245; 2245]); (Difference, [2242; 2246]); (Product, [970; 2208]); (Product, [972;
2206]); (Difference, [2248; 2249]); (Product, [2250; 2250]); (Difference, [2247; 2251]); (Product, [972; 2207]);
(Product, [971; 2208]); (Difference, [2253; 2254]); (Product, [2255; 2255]); (Difference, [2252; 2256]); (Choose (Both
(Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 2241; 2213; 182; 2257]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 2236; 244;
239; 0; 112; 113; 114; 1; 115; 182; 2258]); (Sum, [2205; 106]); (Choose (Less 0 1), [2260; 2205; 182; 2259]); (Root,
[2213]); (Quotient, [177; 2262]); (Product, [2263; 2206]); (Product, [2263; 2207]); (Product, [2263; 2208]); (Product,
[182; 2264]); (Product, [182; 2265]); (Sum, [2267; 2268]); (Product, [177; 2266]); (Sum, [2269; 2270]); (Sum, [2264;
490]); (Sum, [2265; 491])].
Definition from_2100 : list (operation * list N) := [(Sum, [2266; 492]); (Product, [2272; 2272]); (Product, [2273;
2273]); (Sum, [2275; 2276]); (Product, [2274; 2274]); (Sum, [2277; 2278]); (Root, [2279]); (Product, [182; 2272]);
(Product, [182; 2273]); (Sum, [2281; 2282]); (Product, [177; 2274]); (Sum, [2283; 2284]); (Quotient, [2285; 2280]);
(Choose (Less 0 1), [2286; 182; 182; 2286]); (Choose (Less 0 1), [2287; 182; 182; 2280]); (Power, [2288; 38]); (Choose
(Same 0 1), [2271; 2271; 31; 177]); (Choose (Same 0 1), [182; 2289; 31; 177]); (Product, [2262; 490]); (Sum, [2292;
2206]); (Product, [2262; 491]); (Sum, [2294; 2207]); (Product, [2262; 492]); (Sum, [2296; 2208]); (Product, [2293;
2293]); (Product, [2295; 2295]); (Sum, [2298; 2299]); (Product, [2297; 2297]); (Sum, [2300; 2301]); (Sum, [2226; 2230]);
(Product, [177; 2208]); (Sum, [2303; 2304]); (Product, [182; 2293]); (Product, [182; 2295]); (Sum, [2306; 2307]);
(Product, [177; 2297]); (Sum, [2308; 2309]); (Choose (Less 0 1), [2310; 182; 182; 2310]); (Product, [2302; 2262]);
(Quotient, [177; 2312]); (Choose (Less 0 1), [2313; 182; 182; 2302]); (Product, [2305; 2302]); (Product, [2315; 2314]);
(Choose (Less 0 1), [2316; 1058; 182; 2302]); (Product, [2311; 2311]); (Product, [2318; 2262]); (Product, [2319; 2314]);
(Power, [2320; 38]); (Choose (Same 0 1), [2317; 2290; 31; 241]); (Choose (Same 0 1), [2321; 2291; 31; 241])].
Definition from_2150 : list (operation * list N) := [(Product, [241; 2271]); (Product, [2324; 1069]); (Product, [2264;
490]); (Difference, [2325; 2326]); (Product, [2265; 491]); (Difference, [2327; 2328]); (Product, [2266; 492]);
(Difference, [2329; 2330]); (Choose (Less 0 1), [2331; 182; 182; 2331]); (Power, [2332; 38]); (Choose (Same 0 1), [2271;
2322; 31; 239]); (Choose (Same 0 1), [2333; 2323; 31; 239]); (Choose (Same 0 1), [2271; 2334; 31; 358]); (Choose (Same 0
1), [182; 2335; 31; 358]); (Choose (Less 0 1), [2288; 182; 182; 2271]); (Power, [2338; 38]); (Choose (Same 0 1), [2271;
2336; 31; 371]); (Choose (Same 0 1), [2339; 2337; 31; 371]); (Choose (Same 0 1), [2271; 2340; 31; 382]); (Choose (Same 0
1), [182; 2341; 31; 382]); (Choose (Less 0 1), [2320; 182; 182; 2317]); (Power, [2344; 38]); (Choose (Same 0 1), [2317;
2342; 31; 400]); (Choose (Same 0 1), [2345; 2343; 31; 400]); (Choose (Less 0 1), [2346; 182; 182; 2346]); (Product, [10;
2348]); (Product, [11; 2347]); (Product, [549; 2349]); (Sum, [2351; 2350]); (Product, [102; 2352]); (Sum, [2353; 1730]);
(Product, [103; 2352]); (Sum, [1731; 2355]); (Product, [550; 2349]); (Sum, [2357; 2350]); (Product, [104; 2358]); (Sum,
[1732; 2359]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2354; 1730; 244; 239; 0;
182; 2259; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2356; 1731; 244; 239;
0; 182; 2259; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2360; 1732; 244;
239; 0; 182; 2259; 105]); (Choose (Less 0 1), [2361; 182; 182; 2361]); (Choose (Less 0 1), [2364; 177; 2364; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [2365; 2193; 244; 239; 0]); (Choose (Less 0 1), [2362; 182; 182; 2362]); (Choose
(Less 0 1), [2367; 177; 2367; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2368; 2196; 244; 239; 0]); (Choose (Less 0
1), [2363; 182; 182; 2363]); (Choose (Less 0 1), [2370; 177; 2370; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2371;
2199; 244; 239; 0]); (Product, [452; 1900])].
Definition from_2200 : list (operation * list N) := [(Product, [454; 1901]); (Sum, [2373; 2374]); (Product, [455;
1902]); (Sum, [2375; 2376]); (Sum, [2026; 1750]); (Sum, [1751; 2030]); (Sum, [1752; 2034]); (Choose (Both (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [2378; 1750; 244; 177; 0; 182; 1930; 105;
2377]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [2379; 1751;
244; 177; 0; 182; 1930; 105; 2377]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)) (Less 3 6)), [2380; 1752; 244; 177; 0; 182; 1930; 105; 2377]); (Choose (Less 0 1), [2381; 182; 182; 2381]); (Choose
(Less 0 1), [2384; 177; 2384; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2385; 182; 244; 177; 0]); (Choose (Less 0
1), [2382; 182; 182; 2382]); (Choose (Less 0 1), [2387; 177; 2387; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2388;
182; 244; 177; 0]); (Choose (Less 0 1), [2383; 182; 182; 2383]); (Choose (Less 0 1), [2390; 177; 2390; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [2391; 182; 244; 177; 0]); (Sum, [2178; 1765]); (Sum, [1766; 2182]); (Sum, [1767; 2186]);
(Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [2393; 1765; 244; 241;
0; 182; 2082; 105; 2130]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3
6)), [2394; 1766; 244; 241; 0; 182; 2082; 105; 2130]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less
3 4))) (Less 3 5)) (Less 3 6)), [2395; 1767; 244; 241; 0; 182; 2082; 105; 2130]); (Choose (Less 0 1), [2396; 182; 182;
2396]); (Choose (Less 0 1), [2399; 177; 2399; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2400; 2386; 244; 241; 0]);
(Choose (Less 0 1), [2397; 182; 182; 2397]); (Choose (Less 0 1), [2402; 177; 2402; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [2403; 2389; 244; 241; 0]); (Choose (Less 0 1), [2398; 182; 182; 2398]); (Choose (Less 0 1), [2405; 177; 2405;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [2406; 2392; 244; 241; 0]); (Sum, [2353; 1780]); (Sum, [1781; 2355]); (Sum,
[1782; 2359]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [2408;
1780; 244; 239; 0; 182; 2259; 105; 2305]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4)))
(Less 3 5)) (Less 3 6)), [2409; 1781; 244; 239; 0; 182; 2259; 105; 2305]); (Choose (Both (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [2410; 1782; 244; 239; 0; 182; 2259; 105; 2305]); (Choose (Less 0
1), [2411; 182; 182; 2411]); (Choose (Less 0 1), [2414; 177; 2414; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2415;
2401; 244; 239; 0]); (Choose (Less 0 1), [2412; 182; 182; 2412]); (Choose (Less 0 1), [2417; 177; 2417; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [2418; 2404; 244; 239; 0]); (Choose (Less 0 1), [2413; 182; 182; 2413]); (Choose (Less 0
1), [2420; 177; 2420; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2421; 2407; 244; 239; 0]); (Product, [612; 1900])].
Definition from_2250 : list (operation * list N) := [(Product, [613; 1901]); (Sum, [2423; 2424]); (Product, [614;
1902]); (Sum, [2425; 2426]); (Product, [612; 1964]); (Product, [613; 1966]); (Sum, [2428; 2429]); (Product, [614;
1968]); (Sum, [2430; 2431]); (Choose (Less 0 1), [2432; 182; 182; 2432]); (Product, [2427; 1973]); (Product, [2434;
1987]); (Choose (Less 0 1), [2435; 1177; 182; 1973]); (Product, [2433; 2433]); (Product, [2437; 1933]); (Product, [2438;
1987]); (Product, [2439; 2439]); (Product, [2440; 2440]); (Product, [2441; 2441]); (Product, [2442; 2442]); (Choose
(Less 0 1), [2436; 182; 182; 2436]); (Product, [10; 2444]); (Product, [11; 2443]); (Product, [12; 2445]); (Sum, [2447;
2446]); (Product, [102; 2448]); (Sum, [2449; 1828]); (Product, [13; 2445]); (Sum, [2451; 2446]); (Product, [103; 2452]);
(Sum, [1829; 2453]); (Product, [14; 2445]); (Sum, [2455; 2446]); (Product, [104; 2456]); (Sum, [1830; 2457]); (Choose
(Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2450; 1828; 244; 177; 0; 182; 1930; 105]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2454; 1829; 244; 177; 0; 182; 1930;
105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2458; 1830; 244; 177; 0; 182;
1930; 105]); (Choose (Less 0 1), [2459; 182; 182; 2459]); (Choose (Less 0 1), [2462; 177; 2462; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [2463; 182; 244; 177; 0]); (Choose (Less 0 1), [2460; 182; 182; 2460]); (Choose (Less 0 1),
[2465; 177; 2465; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2466; 182; 244; 177; 0]); (Choose (Less 0 1), [2461;
182; 182; 2461]); (Choose (Less 0 1), [2468; 177; 2468; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2469; 182; 244;
177; 0]); (Product, [2145; 2145]); (Product, [2471; 2471]); (Product, [2472; 2472])].
Definition from_2300 : list (operation * list N) := [(Product, [2473; 2473]); (Choose (Less 0 1), [2142; 182; 182;
2142]); (Product, [10; 2475]); (Product, [11; 2474]); (Product, [15; 2476]); (Sum, [2478; 2477]); (Product, [102;
2479]); (Sum, [2480; 1859]); (Product, [16; 2476]); (Sum, [2482; 2477]); (Product, [103; 2483]); (Sum, [1860; 2484]);
(Product, [17; 2476]); (Sum, [2486; 2477]); (Product, [104; 2487]); (Sum, [1861; 2488]); (Choose (Both (Both (Both (Same
0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2481; 1859; 244; 241; 0; 182; 2082; 105]); (Choose (Both (Both (Both
(Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2485; 1860; 244; 241; 0; 182; 2082; 105]); (Choose (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2489; 1861; 244; 241; 0; 182; 2082; 105]); (Choose (Less 0
1), [2490; 182; 182; 2490]); (Choose (Less 0 1), [2493; 177; 2493; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2494;
2464; 244; 241; 0]); (Choose (Less 0 1), [2491; 182; 182; 2491]); (Choose (Less 0 1), [2496; 177; 2496; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [2497; 2467; 244; 241; 0]); (Choose (Less 0 1), [2492; 182; 182; 2492]); (Choose (Less 0
1), [2499; 177; 2499; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2500; 2470; 244; 241; 0]); (Product, [2320; 2320]);
(Product, [2502; 2502]); (Product, [2503; 2503]); (Product, [2504; 2504]); (Choose (Less 0 1), [2317; 182; 182; 2317]);
(Product, [10; 2506]); (Product, [11; 2505]); (Product, [549; 2507]); (Sum, [2509; 2508]); (Product, [102; 2510]); (Sum,
[2511; 1888]); (Product, [103; 2510]); (Sum, [1889; 2513]); (Product, [550; 2507]); (Sum, [2515; 2508]); (Product, [104;
2516]); (Sum, [1890; 2517]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2512;
1888; 244; 239; 0; 182; 2259; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)),
[2514; 1889; 244; 239; 0; 182; 2259; 105]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)), [2518; 1890; 244; 239; 0; 182; 2259; 105]); (Choose (Less 0 1), [2519; 182; 182; 2519]); (Choose (Less 0 1), [2522;
177; 2522; 177])].
Definition from_2350 : list (operation * list N) := [(Choose (Both (Same 0 1) (Same 2 2)), [2523; 2495; 244; 239; 0]);
(Choose (Less 0 1), [2520; 182; 182; 2520]); (Choose (Less 0 1), [2525; 177; 2525; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [2526; 2498; 244; 239; 0]); (Choose (Less 0 1), [2521; 182; 182; 2521]); (Choose (Less 0 1), [2528; 177; 2528;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [2529; 2501; 244; 239; 0]); (Difference, [124; 452]); (Difference, [125;
454]); (Difference, [126; 455]); (Product, [2531; 2531]); (Product, [2532; 2532]); (Sum, [2534; 2535]); (Product, [2533;
2533]); (Sum, [2536; 2537]); (Product, [618; 2531]); (Product, [619; 2532]); (Sum, [2539; 2540]); (Product, [620;
2533]); (Sum, [2541; 2542]); (Product, [207; 2538]); (Product, [619; 2531]); (Product, [618; 2532]); (Difference, [2545;
2546]); (Product, [2547; 2547]); (Difference, [2544; 2548]); (Product, [618; 2533]); (Product, [620; 2531]);
(Difference, [2550; 2551]); (Product, [2552; 2552]); (Difference, [2549; 2553]); (Product, [620; 2532]); (Product, [619;
2533]); (Difference, [2555; 2556]); (Product, [2557; 2557]); (Difference, [2554; 2558]); (Choose (Both (Both (Less 0 1)
(At_most 2 3)) (Less 2 0)), [177; 182; 2543; 2538; 182; 2559]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both
(Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 177; 0; 141; 142;
143; 1; 144; 182; 2560]); (Sum, [1932; 131]); (Choose (Less 0 1), [2562; 1932; 182; 2561]); (Root, [2538]); (Quotient,
[177; 2564]); (Product, [2565; 2531]); (Product, [2565; 2532]); (Product, [2565; 2533]); (Product, [484; 2566]);
(Product, [485; 2567]); (Sum, [2569; 2570]); (Product, [486; 2568]); (Sum, [2571; 2572])].
Definition from_2400 : list (operation * list N) := [(Sum, [2566; 490]); (Sum, [2567; 491]); (Sum, [2568; 492]);
(Product, [2574; 2574]); (Product, [2575; 2575]); (Sum, [2577; 2578]); (Product, [2576; 2576]); (Sum, [2579; 2580]);
(Root, [2581]); (Product, [484; 2574]); (Product, [485; 2575]); (Sum, [2583; 2584]); (Product, [486; 2576]); (Sum,
[2585; 2586]); (Quotient, [2587; 2582]); (Choose (Less 0 1), [2588; 182; 182; 2588]); (Choose (Less 0 1), [2589; 182;
182; 2582]); (Power, [2590; 38]); (Choose (Same 0 1), [2573; 2573; 31; 177]); (Choose (Same 0 1), [182; 2591; 31; 177]);
(Product, [2564; 490]); (Sum, [2594; 2531]); (Product, [2564; 491]); (Sum, [2596; 2532]); (Product, [2564; 492]); (Sum,
[2598; 2533]); (Product, [2595; 2595]); (Product, [2597; 2597]); (Sum, [2600; 2601]); (Product, [2599; 2599]); (Sum,
[2602; 2603]); (Product, [484; 2531]); (Product, [485; 2532]); (Sum, [2605; 2606]); (Product, [486; 2533]); (Sum, [2607;
2608]); (Product, [484; 2595]); (Product, [485; 2597]); (Sum, [2610; 2611]); (Product, [486; 2599]); (Sum, [2612;
2613]); (Choose (Less 0 1), [2614; 182; 182; 2614]); (Product, [2604; 2564]); (Quotient, [177; 2616]); (Choose (Less 0
1), [2617; 182; 182; 2604]); (Product, [2609; 2604]); (Product, [2619; 2618]); (Choose (Less 0 1), [2620; 713; 182;
2604]); (Product, [2615; 2615]); (Product, [2622; 2564])].
Definition from_2450 : list (operation * list N) := [(Product, [2623; 2618]); (Power, [2624; 38]); (Choose (Same 0 1),
[2621; 2592; 31; 241]); (Choose (Same 0 1), [2625; 2593; 31; 241]); (Product, [241; 2573]); (Product, [2628; 724]);
(Product, [2566; 490]); (Difference, [2629; 2630]); (Product, [2567; 491]); (Difference, [2631; 2632]); (Product, [2568;
492]); (Difference, [2633; 2634]); (Choose (Less 0 1), [2635; 182; 182; 2635]); (Power, [2636; 38]); (Choose (Same 0 1),
[2573; 2626; 31; 239]); (Choose (Same 0 1), [2637; 2627; 31; 239]); (Choose (Same 0 1), [2573; 2638; 31; 358]); (Choose
(Same 0 1), [182; 2639; 31; 358]); (Choose (Less 0 1), [2590; 182; 182; 2573]); (Power, [2642; 38]); (Choose (Same 0 1),
[2573; 2640; 31; 371]); (Choose (Same 0 1), [2643; 2641; 31; 371]); (Choose (Same 0 1), [2573; 2644; 31; 382]); (Choose
(Same 0 1), [182; 2645; 31; 382]); (Choose (Less 0 1), [2624; 182; 182; 2621]); (Power, [2648; 38]); (Choose (Same 0 1),
[2621; 2646; 31; 400]); (Choose (Same 0 1), [2649; 2647; 31; 400]); (Choose (Less 0 1), [2650; 182; 182; 2650]);
(Product, [10; 2652]); (Product, [11; 2651]); (Product, [12; 2653]); (Sum, [2655; 2654]); (Product, [127; 2656]); (Sum,
[2657; 2036]); (Product, [13; 2653]); (Sum, [2659; 2654]); (Product, [128; 2660]); (Sum, [2037; 2661]); (Product, [14;
2653]); (Sum, [2663; 2654]); (Product, [129; 2664]); (Sum, [2038; 2665]); (Choose (Both (Both (Both (Same 0 1) (Same 2
2)) (Not (Less 3 4))) (Less 3 5)), [2658; 2036; 244; 177; 0; 182; 2561; 130]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2662; 2037; 244; 177; 0; 182; 2561; 130]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2666; 2038; 244; 177; 0; 182; 2561; 130]); (Choose (Less 0 1), [2667;
182; 182; 2667]); (Choose (Less 0 1), [2670; 177; 2670; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2671; 182; 244;
177; 0]); (Choose (Less 0 1), [2668; 182; 182; 2668])].
Definition from_2500 : list (operation * list N) := [(Choose (Less 0 1), [2673; 177; 2673; 177]); (Choose (Both (Same 0
1) (Same 2 2)), [2674; 182; 244; 177; 0]); (Choose (Less 0 1), [2669; 182; 182; 2669]); (Choose (Less 0 1), [2676; 177;
2676; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2677; 182; 244; 177; 0]); (Sum, [2563; 56]); (Choose (Less 0 1),
[2679; 2563; 182; 808]); (Sum, [2680; 81]); (Choose (Less 0 1), [2681; 2680; 182; 1453]); (Sum, [2682; 106]); (Choose
(Less 0 1), [2683; 2682; 182; 2082]); (Difference, [124; 531]); (Difference, [125; 533]); (Difference, [126; 535]);
(Product, [2685; 2685]); (Product, [2686; 2686]); (Sum, [2688; 2689]); (Product, [2687; 2687]); (Sum, [2690; 2691]);
(Product, [778; 2685]); (Product, [779; 2686]); (Sum, [2693; 2694]); (Product, [780; 2687]); (Sum, [2695; 2696]);
(Product, [254; 2692]); (Product, [779; 2685]); (Product, [778; 2686]); (Difference, [2699; 2700]); (Product, [2701;
2701]); (Difference, [2698; 2702]); (Product, [778; 2687]); (Product, [780; 2685]); (Difference, [2704; 2705]);
(Product, [2706; 2706]); (Difference, [2703; 2707]); (Product, [780; 2686]); (Product, [779; 2687]); (Difference, [2709;
2710]); (Product, [2711; 2711]); (Difference, [2708; 2712]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)),
[177; 182; 2697; 2692; 182; 2713]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2)
(At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 241; 0; 145; 146; 147; 1; 148; 182; 2714]);
(Sum, [2684; 131]); (Choose (Less 0 1), [2716; 2684; 182; 2715]); (Root, [2692]); (Quotient, [177; 2718]); (Product,
[2719; 2685]); (Product, [2719; 2686]); (Product, [2719; 2687]); (Product, [527; 2720])].
Definition from_2550 : list (operation * list N) := [(Product, [528; 2721]); (Sum, [2723; 2724]); (Product, [529;
2722]); (Sum, [2725; 2726]); (Sum, [2720; 490]); (Sum, [2721; 491]); (Sum, [2722; 492]); (Product, [2728; 2728]);
(Product, [2729; 2729]); (Sum, [2731; 2732]); (Product, [2730; 2730]); (Sum, [2733; 2734]); (Root, [2735]); (Product,
[527; 2728]); (Product, [528; 2729]); (Sum, [2737; 2738]); (Product, [529; 2730]); (Sum, [2739; 2740]); (Quotient,
[2741; 2736]); (Choose (Less 0 1), [2742; 182; 182; 2742]); (Choose (Less 0 1), [2743; 182; 182; 2736]); (Power, [2744;
38]); (Choose (Same 0 1), [2727; 2727; 31; 177]); (Choose (Same 0 1), [182; 2745; 31; 177]); (Product, [2718; 490]);
(Sum, [2748; 2685]); (Product, [2718; 491]); (Sum, [2750; 2686]); (Product, [2718; 492]); (Sum, [2752; 2687]); (Product,
[2749; 2749]); (Product, [2751; 2751]); (Sum, [2754; 2755]); (Product, [2753; 2753]); (Sum, [2756; 2757]); (Product,
[527; 2685]); (Product, [528; 2686]); (Sum, [2759; 2760]); (Product, [529; 2687]); (Sum, [2761; 2762]); (Product, [527;
2749]); (Product, [528; 2751]); (Sum, [2764; 2765]); (Product, [529; 2753]); (Sum, [2766; 2767]); (Choose (Less 0 1),
[2768; 182; 182; 2768]); (Product, [2758; 2718]); (Quotient, [177; 2770]); (Choose (Less 0 1), [2771; 182; 182; 2758]);
(Product, [2763; 2758])].
Definition from_2600 : list (operation * list N) := [(Product, [2773; 2772]); (Choose (Less 0 1), [2774; 873; 182;
2758]); (Product, [2769; 2769]); (Product, [2776; 2718]); (Product, [2777; 2772]); (Power, [2778; 38]); (Choose (Same 0
1), [2775; 2746; 31; 241]); (Choose (Same 0 1), [2779; 2747; 31; 241]); (Product, [241; 2727]); (Product, [2782; 884]);
(Product, [2720; 490]); (Difference, [2783; 2784]); (Product, [2721; 491]); (Difference, [2785; 2786]); (Product, [2722;
492]); (Difference, [2787; 2788]); (Choose (Less 0 1), [2789; 182; 182; 2789]); (Power, [2790; 38]); (Choose (Same 0 1),
[2727; 2780; 31; 239]); (Choose (Same 0 1), [2791; 2781; 31; 239]); (Choose (Same 0 1), [2727; 2792; 31; 358]); (Choose
(Same 0 1), [182; 2793; 31; 358]); (Choose (Less 0 1), [2744; 182; 182; 2727]); (Power, [2796; 38]); (Choose (Same 0 1),
[2727; 2794; 31; 371]); (Choose (Same 0 1), [2797; 2795; 31; 371]); (Choose (Same 0 1), [2727; 2798; 31; 382]); (Choose
(Same 0 1), [182; 2799; 31; 382]); (Choose (Less 0 1), [2778; 182; 182; 2775]); (Power, [2802; 38]); (Choose (Same 0 1),
[2775; 2800; 31; 400]); (Choose (Same 0 1), [2803; 2801; 31; 400]); (Choose (Less 0 1), [2804; 182; 182; 2804]);
(Product, [10; 2806]); (Product, [11; 2805]); (Product, [15; 2807]); (Sum, [2809; 2808]); (Product, [127; 2810]); (Sum,
[2811; 2188]); (Product, [16; 2807]); (Sum, [2813; 2808]); (Product, [128; 2814]); (Sum, [2189; 2815]); (Product, [17;
2807]); (Sum, [2817; 2808]); (Product, [129; 2818]); (Sum, [2190; 2819]); (Choose (Both (Both (Both (Same 0 1) (Same 2
2)) (Not (Less 3 4))) (Less 3 5)), [2812; 2188; 244; 241; 0; 182; 2715; 130]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2816; 2189; 244; 241; 0; 182; 2715; 130]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2820; 2190; 244; 241; 0; 182; 2715; 130])].
Definition from_2650 : list (operation * list N) := [(Choose (Less 0 1), [2821; 182; 182; 2821]); (Choose (Less 0 1),
[2824; 177; 2824; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2825; 2672; 244; 241; 0]); (Choose (Less 0 1), [2822;
182; 182; 2822]); (Choose (Less 0 1), [2827; 177; 2827; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [2828; 2675; 244;
241; 0]); (Choose (Less 0 1), [2823; 182; 182; 2823]); (Choose (Less 0 1), [2830; 177; 2830; 177]); (Choose (Both (Same
0 1) (Same 2 2)), [2831; 2678; 244; 241; 0]); (Sum, [2717; 546]); (Choose (Both (Both (Same 0 1) (Same 2 2)) (Less 3
4)), [2833; 2717; 244; 239; 0; 182; 545]); (Sum, [2834; 56]); (Choose (Less 0 1), [2835; 2834; 182; 995]); (Sum, [2836;
81]); (Choose (Less 0 1), [2837; 2836; 182; 1628]); (Sum, [2838; 106]); (Choose (Less 0 1), [2839; 2838; 182; 2259]);
(Difference, [124; 0]); (Difference, [125; 1]); (Difference, [126; 182]); (Product, [2841; 2841]); (Product, [2842;
2842]); (Sum, [2844; 2845]); (Product, [2843; 2843]); (Sum, [2846; 2847]); (Product, [940; 2841]); (Product, [941;
2842]); (Sum, [2849; 2850]); (Product, [182; 2843]); (Sum, [2851; 2852]); (Product, [254; 2848]); (Product, [941;
2841]); (Product, [940; 2842]); (Difference, [2855; 2856]); (Product, [2857; 2857]); (Difference, [2854; 2858]);
(Product, [940; 2843]); (Product, [182; 2841]); (Difference, [2860; 2861]); (Product, [2862; 2862]); (Difference, [2859;
2863]); (Product, [182; 2842]); (Product, [941; 2843]); (Difference, [2865; 2866]); (Product, [2867; 2867]);
(Difference, [2864; 2868]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 2853; 2848; 182;
2869]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6))
(At_most 6 7))) (Less 8 9)), [177; 182; 244; 239; 0; 133; 134; 135; 1; 136; 182; 2870]); (Product, [970; 2841]);
(Product, [971; 2842])].
Definition from_2700 : list (operation * list N) := [(Sum, [2872; 2873]); (Product, [972; 2843]); (Sum, [2874; 2875]);
(Product, [207; 2848]); (Product, [971; 2841]); (Product, [970; 2842]); (Difference, [2878; 2879]); (Product, [2880;
2880]); (Difference, [2877; 2881]); (Product, [970; 2843]); (Product, [972; 2841]); (Difference, [2883; 2884]);
(Product, [2885; 2885]); (Difference, [2882; 2886]); (Product, [972; 2842]); (Product, [971; 2843]); (Difference, [2888;
2889]); (Product, [2890; 2890]); (Difference, [2887; 2891]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)),
[177; 182; 2876; 2848; 182; 2892]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2)
(At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 2871; 244; 239; 0; 137; 138; 139; 1; 140; 182; 2893]);
(Sum, [2840; 131]); (Choose (Less 0 1), [2895; 2840; 182; 2894]); (Root, [2848]); (Quotient, [177; 2897]); (Product,
[2898; 2841]); (Product, [2898; 2842]); (Product, [2898; 2843]); (Product, [182; 2899]); (Product, [182; 2900]); (Sum,
[2902; 2903]); (Product, [177; 2901]); (Sum, [2904; 2905]); (Sum, [2899; 490]); (Sum, [2900; 491]); (Sum, [2901; 492]);
(Product, [2907; 2907]); (Product, [2908; 2908]); (Sum, [2910; 2911]); (Product, [2909; 2909]); (Sum, [2912; 2913]);
(Root, [2914]); (Product, [182; 2907]); (Product, [182; 2908]); (Sum, [2916; 2917]); (Product, [177; 2909]); (Sum,
[2918; 2919]); (Quotient, [2920; 2915]); (Choose (Less 0 1), [2921; 182; 182; 2921]); (Choose (Less 0 1), [2922; 182;
182; 2915])].
Definition from_2750 : list (operation * list N) := [(Power, [2923; 38]); (Choose (Same 0 1), [2906; 2906; 31; 177]);
(Choose (Same 0 1), [182; 2924; 31; 177]); (Product, [2897; 490]); (Sum, [2927; 2841]); (Product, [2897; 491]); (Sum,
[2929; 2842]); (Product, [2897; 492]); (Sum, [2931; 2843]); (Product, [2928; 2928]); (Product, [2930; 2930]); (Sum,
[2933; 2934]); (Product, [2932; 2932]); (Sum, [2935; 2936]); (Sum, [2861; 2865]); (Product, [177; 2843]); (Sum, [2938;
2939]); (Product, [182; 2928]); (Product, [182; 2930]); (Sum, [2941; 2942]); (Product, [177; 2932]); (Sum, [2943;
2944]); (Choose (Less 0 1), [2945; 182; 182; 2945]); (Product, [2937; 2897]); (Quotient, [177; 2947]); (Choose (Less 0
1), [2948; 182; 182; 2937]); (Product, [2940; 2937]); (Product, [2950; 2949]); (Choose (Less 0 1), [2951; 1058; 182;
2937]); (Product, [2946; 2946]); (Product, [2953; 2897]); (Product, [2954; 2949]); (Power, [2955; 38]); (Choose (Same 0
1), [2952; 2925; 31; 241]); (Choose (Same 0 1), [2956; 2926; 31; 241]); (Product, [241; 2906]); (Product, [2959; 1069]);
(Product, [2899; 490]); (Difference, [2960; 2961]); (Product, [2900; 491]); (Difference, [2962; 2963]); (Product, [2901;
492]); (Difference, [2964; 2965]); (Choose (Less 0 1), [2966; 182; 182; 2966]); (Power, [2967; 38]); (Choose (Same 0 1),
[2906; 2957; 31; 239]); (Choose (Same 0 1), [2968; 2958; 31; 239]); (Choose (Same 0 1), [2906; 2969; 31; 358]); (Choose
(Same 0 1), [182; 2970; 31; 358]); (Choose (Less 0 1), [2923; 182; 182; 2906])].
Definition from_2800 : list (operation * list N) := [(Power, [2973; 38]); (Choose (Same 0 1), [2906; 2971; 31; 371]);
(Choose (Same 0 1), [2974; 2972; 31; 371]); (Choose (Same 0 1), [2906; 2975; 31; 382]); (Choose (Same 0 1), [182; 2976;
31; 382]); (Choose (Less 0 1), [2955; 182; 182; 2952]); (Power, [2979; 38]); (Choose (Same 0 1), [2952; 2977; 31; 400]);
(Choose (Same 0 1), [2980; 2978; 31; 400]); (Choose (Less 0 1), [2981; 182; 182; 2981]); (Product, [10; 2983]);
(Product, [11; 2982]); (Product, [549; 2984]); (Sum, [2986; 2985]); (Product, [127; 2987]); (Sum, [2988; 2361]);
(Product, [128; 2987]); (Sum, [2362; 2990]); (Product, [550; 2984]); (Sum, [2992; 2985]); (Product, [129; 2993]); (Sum,
[2363; 2994]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2989; 2361; 244; 239; 0;
182; 2894; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2991; 2362; 244; 239;
0; 182; 2894; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [2995; 2363; 244;
239; 0; 182; 2894; 130]); (Choose (Less 0 1), [2996; 182; 182; 2996]); (Choose (Less 0 1), [2999; 177; 2999; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [3000; 2826; 244; 239; 0]); (Choose (Less 0 1), [2997; 182; 182; 2997]); (Choose
(Less 0 1), [3002; 177; 3002; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3003; 2829; 244; 239; 0]); (Choose (Less 0
1), [2998; 182; 182; 2998]); (Choose (Less 0 1), [3005; 177; 3005; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3006;
2832; 244; 239; 0]); (Product, [452; 2531]); (Product, [454; 2532]); (Sum, [3008; 3009]); (Product, [455; 2533]); (Sum,
[3010; 3011]); (Sum, [2657; 2381]); (Sum, [2382; 2661]); (Sum, [2383; 2665]); (Choose (Both (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3013; 2381; 244; 177; 0; 182; 2561; 130; 3012]); (Choose (Both
(Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3014; 2382; 244; 177; 0; 182; 2561;
130; 3012]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3015;
2383; 244; 177; 0; 182; 2561; 130; 3012]); (Choose (Less 0 1), [3016; 182; 182; 3016]); (Choose (Less 0 1), [3019; 177;
3019; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3020; 182; 244; 177; 0]); (Choose (Less 0 1), [3017; 182; 182;
3017]); (Choose (Less 0 1), [3022; 177; 3022; 177])].
Definition from_2850 : list (operation * list N) := [(Choose (Both (Same 0 1) (Same 2 2)), [3023; 182; 244; 177; 0]);
(Choose (Less 0 1), [3018; 182; 182; 3018]); (Choose (Less 0 1), [3025; 177; 3025; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [3026; 182; 244; 177; 0]); (Sum, [2811; 2396]); (Sum, [2397; 2815]); (Sum, [2398; 2819]); (Choose (Both (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3028; 2396; 244; 241; 0; 182; 2715; 130;
2763]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3029; 2397;
244; 241; 0; 182; 2715; 130; 2763]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)) (Less 3 6)), [3030; 2398; 244; 241; 0; 182; 2715; 130; 2763]); (Choose (Less 0 1), [3031; 182; 182; 3031]); (Choose
(Less 0 1), [3034; 177; 3034; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3035; 3021; 244; 241; 0]); (Choose (Less 0
1), [3032; 182; 182; 3032]); (Choose (Less 0 1), [3037; 177; 3037; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3038;
3024; 244; 241; 0]); (Choose (Less 0 1), [3033; 182; 182; 3033]); (Choose (Less 0 1), [3040; 177; 3040; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [3041; 3027; 244; 241; 0]); (Sum, [2988; 2411]); (Sum, [2412; 2990]); (Sum, [2413; 2994]);
(Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3043; 2411; 244; 239;
0; 182; 2894; 130; 2940]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3
6)), [3044; 2412; 244; 239; 0; 182; 2894; 130; 2940]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less
3 4))) (Less 3 5)) (Less 3 6)), [3045; 2413; 244; 239; 0; 182; 2894; 130; 2940]); (Choose (Less 0 1), [3046; 182; 182;
3046]); (Choose (Less 0 1), [3049; 177; 3049; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3050; 3036; 244; 239; 0]);
(Choose (Less 0 1), [3047; 182; 182; 3047]); (Choose (Less 0 1), [3052; 177; 3052; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [3053; 3039; 244; 239; 0]); (Choose (Less 0 1), [3048; 182; 182; 3048]); (Choose (Less 0 1), [3055; 177; 3055;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [3056; 3042; 244; 239; 0]); (Product, [612; 2531]); (Product, [613; 2532]);
(Sum, [3058; 3059]); (Product, [614; 2533]); (Sum, [3060; 3061]); (Product, [612; 2595]); (Product, [613; 2597]); (Sum,
[3063; 3064]); (Product, [614; 2599]); (Sum, [3065; 3066]); (Choose (Less 0 1), [3067; 182; 182; 3067]); (Product,
[3062; 2604]); (Product, [3069; 2618]); (Choose (Less 0 1), [3070; 1177; 182; 2604]); (Product, [3068; 3068]); (Product,
[3072; 2564])].
Definition from_2900 : list (operation * list N) := [(Product, [3073; 2618]); (Product, [3074; 3074]); (Product, [3075;
3075]); (Product, [3076; 3076]); (Product, [3077; 3077]); (Choose (Less 0 1), [3071; 182; 182; 3071]); (Product, [10;
3079]); (Product, [11; 3078]); (Product, [12; 3080]); (Sum, [3082; 3081]); (Product, [127; 3083]); (Sum, [3084; 2459]);
(Product, [13; 3080]); (Sum, [3086; 3081]); (Product, [128; 3087]); (Sum, [2460; 3088]); (Product, [14; 3080]); (Sum,
[3090; 3081]); (Product, [129; 3091]); (Sum, [2461; 3092]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less
3 4))) (Less 3 5)), [3085; 2459; 244; 177; 0; 182; 2561; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)), [3089; 2460; 244; 177; 0; 182; 2561; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)), [3093; 2461; 244; 177; 0; 182; 2561; 130]); (Choose (Less 0 1), [3094; 182; 182; 3094]);
(Choose (Less 0 1), [3097; 177; 3097; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3098; 182; 244; 177; 0]); (Choose
(Less 0 1), [3095; 182; 182; 3095]); (Choose (Less 0 1), [3100; 177; 3100; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[3101; 182; 244; 177; 0]); (Choose (Less 0 1), [3096; 182; 182; 3096]); (Choose (Less 0 1), [3103; 177; 3103; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [3104; 182; 244; 177; 0]); (Product, [2778; 2778]); (Product, [3106; 3106]);
(Product, [3107; 3107]); (Product, [3108; 3108]); (Choose (Less 0 1), [2775; 182; 182; 2775]); (Product, [10; 3110]);
(Product, [11; 3109]); (Product, [15; 3111]); (Sum, [3113; 3112]); (Product, [127; 3114]); (Sum, [3115; 2490]);
(Product, [16; 3111]); (Sum, [3117; 3112]); (Product, [128; 3118]); (Sum, [2491; 3119]); (Product, [17; 3111]); (Sum,
[3121; 3112]); (Product, [129; 3122])].
Definition from_2950 : list (operation * list N) := [(Sum, [2492; 3123]); (Choose (Both (Both (Both (Same 0 1) (Same 2
2)) (Not (Less 3 4))) (Less 3 5)), [3116; 2490; 244; 241; 0; 182; 2715; 130]); (Choose (Both (Both (Both (Same 0 1)
(Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3120; 2491; 244; 241; 0; 182; 2715; 130]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3124; 2492; 244; 241; 0; 182; 2715; 130]); (Choose (Less 0 1), [3125;
182; 182; 3125]); (Choose (Less 0 1), [3128; 177; 3128; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3129; 3099; 244;
241; 0]); (Choose (Less 0 1), [3126; 182; 182; 3126]); (Choose (Less 0 1), [3131; 177; 3131; 177]); (Choose (Both (Same
0 1) (Same 2 2)), [3132; 3102; 244; 241; 0]); (Choose (Less 0 1), [3127; 182; 182; 3127]); (Choose (Less 0 1), [3134;
177; 3134; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3135; 3105; 244; 241; 0]); (Product, [2955; 2955]); (Product,
[3137; 3137]); (Product, [3138; 3138]); (Product, [3139; 3139]); (Choose (Less 0 1), [2952; 182; 182; 2952]); (Product,
[10; 3141]); (Product, [11; 3140]); (Product, [549; 3142]); (Sum, [3144; 3143]); (Product, [127; 3145]); (Sum, [3146;
2519]); (Product, [128; 3145]); (Sum, [2520; 3148]); (Product, [550; 3142]); (Sum, [3150; 3143]); (Product, [129;
3151]); (Sum, [2521; 3152]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3147;
2519; 244; 239; 0; 182; 2894; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)),
[3149; 2520; 244; 239; 0; 182; 2894; 130]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)), [3153; 2521; 244; 239; 0; 182; 2894; 130]); (Choose (Less 0 1), [3154; 182; 182; 3154]); (Choose (Less 0 1), [3157;
177; 3157; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3158; 3130; 244; 239; 0]); (Choose (Less 0 1), [3155; 182; 182;
3155]); (Choose (Less 0 1), [3160; 177; 3160; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3161; 3133; 244; 239; 0]);
(Choose (Less 0 1), [3156; 182; 182; 3156]); (Choose (Less 0 1), [3163; 177; 3163; 177]); (Choose (Both (Same 0 1) (Same
2 2)), [3164; 3136; 244; 239; 0]); (Difference, [149; 452]); (Difference, [150; 454]); (Difference, [151; 455]);
(Product, [3166; 3166]); (Product, [3167; 3167]); (Sum, [3169; 3170]); (Product, [3168; 3168]); (Sum, [3171; 3172])].
Definition from_3000 : list (operation * list N) := [(Product, [618; 3166]); (Product, [619; 3167]); (Sum, [3174;
3175]); (Product, [620; 3168]); (Sum, [3176; 3177]); (Product, [207; 3173]); (Product, [619; 3166]); (Product, [618;
3167]); (Difference, [3180; 3181]); (Product, [3182; 3182]); (Difference, [3179; 3183]); (Product, [618; 3168]);
(Product, [620; 3166]); (Difference, [3185; 3186]); (Product, [3187; 3187]); (Difference, [3184; 3188]); (Product, [620;
3167]); (Product, [619; 3168]); (Difference, [3190; 3191]); (Product, [3192; 3192]); (Difference, [3189; 3193]); (Choose
(Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 3178; 3173; 182; 3194]); (Choose (Both (Both (Both (Same 0
1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6)) (At_most 6 7))) (Less 8 9)), [177; 182;
244; 177; 0; 166; 167; 168; 1; 169; 182; 3195]); (Sum, [2563; 156]); (Choose (Less 0 1), [3197; 2563; 182; 3196]);
(Root, [3173]); (Quotient, [177; 3199]); (Product, [3200; 3166]); (Product, [3200; 3167]); (Product, [3200; 3168]);
(Product, [484; 3201]); (Product, [485; 3202]); (Sum, [3204; 3205]); (Product, [486; 3203]); (Sum, [3206; 3207]); (Sum,
[3201; 490]); (Sum, [3202; 491]); (Sum, [3203; 492]); (Product, [3209; 3209]); (Product, [3210; 3210]); (Sum, [3212;
3213]); (Product, [3211; 3211]); (Sum, [3214; 3215]); (Root, [3216]); (Product, [484; 3209]); (Product, [485; 3210]);
(Sum, [3218; 3219]); (Product, [486; 3211]); (Sum, [3220; 3221]); (Quotient, [3222; 3217])].
Definition from_3050 : list (operation * list N) := [(Choose (Less 0 1), [3223; 182; 182; 3223]); (Choose (Less 0 1),
[3224; 182; 182; 3217]); (Power, [3225; 38]); (Choose (Same 0 1), [3208; 3208; 31; 177]); (Choose (Same 0 1), [182;
3226; 31; 177]); (Product, [3199; 490]); (Sum, [3229; 3166]); (Product, [3199; 491]); (Sum, [3231; 3167]); (Product,
[3199; 492]); (Sum, [3233; 3168]); (Product, [3230; 3230]); (Product, [3232; 3232]); (Sum, [3235; 3236]); (Product,
[3234; 3234]); (Sum, [3237; 3238]); (Product, [484; 3166]); (Product, [485; 3167]); (Sum, [3240; 3241]); (Product, [486;
3168]); (Sum, [3242; 3243]); (Product, [484; 3230]); (Product, [485; 3232]); (Sum, [3245; 3246]); (Product, [486;
3234]); (Sum, [3247; 3248]); (Choose (Less 0 1), [3249; 182; 182; 3249]); (Product, [3239; 3199]); (Quotient, [177;
3251]); (Choose (Less 0 1), [3252; 182; 182; 3239]); (Product, [3244; 3239]); (Product, [3254; 3253]); (Choose (Less 0
1), [3255; 713; 182; 3239]); (Product, [3250; 3250]); (Product, [3257; 3199]); (Product, [3258; 3253]); (Power, [3259;
38]); (Choose (Same 0 1), [3256; 3227; 31; 241]); (Choose (Same 0 1), [3260; 3228; 31; 241]); (Product, [241; 3208]);
(Product, [3263; 724]); (Product, [3201; 490]); (Difference, [3264; 3265]); (Product, [3202; 491]); (Difference, [3266;
3267]); (Product, [3203; 492]); (Difference, [3268; 3269]); (Choose (Less 0 1), [3270; 182; 182; 3270]); (Power, [3271;
38]); (Choose (Same 0 1), [3208; 3261; 31; 239])].
Definition from_3100 : list (operation * list N) := [(Choose (Same 0 1), [3272; 3262; 31; 239]); (Choose (Same 0 1),
[3208; 3273; 31; 358]); (Choose (Same 0 1), [182; 3274; 31; 358]); (Choose (Less 0 1), [3225; 182; 182; 3208]); (Power,
[3277; 38]); (Choose (Same 0 1), [3208; 3275; 31; 371]); (Choose (Same 0 1), [3278; 3276; 31; 371]); (Choose (Same 0 1),
[3208; 3279; 31; 382]); (Choose (Same 0 1), [182; 3280; 31; 382]); (Choose (Less 0 1), [3259; 182; 182; 3256]); (Power,
[3283; 38]); (Choose (Same 0 1), [3256; 3281; 31; 400]); (Choose (Same 0 1), [3284; 3282; 31; 400]); (Choose (Less 0 1),
[3285; 182; 182; 3285]); (Product, [10; 3287]); (Product, [11; 3286]); (Product, [12; 3288]); (Sum, [3290; 3289]);
(Product, [152; 3291]); (Sum, [3292; 2667]); (Product, [13; 3288]); (Sum, [3294; 3289]); (Product, [153; 3295]); (Sum,
[2668; 3296]); (Product, [14; 3288]); (Sum, [3298; 3289]); (Product, [154; 3299]); (Sum, [2669; 3300]); (Choose (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3293; 2667; 244; 177; 0; 182; 3196; 155]); (Choose
(Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3297; 2668; 244; 177; 0; 182; 3196; 155]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3301; 2669; 244; 177; 0; 182; 3196;
155]); (Choose (Less 0 1), [3302; 182; 182; 3302]); (Choose (Less 0 1), [3305; 177; 3305; 177]); (Choose (Both (Same 0
1) (Same 2 2)), [3306; 182; 244; 177; 0]); (Choose (Less 0 1), [3303; 182; 182; 3303]); (Choose (Less 0 1), [3308; 177;
3308; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3309; 182; 244; 177; 0]); (Choose (Less 0 1), [3304; 182; 182;
3304]); (Choose (Less 0 1), [3311; 177; 3311; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3312; 182; 244; 177; 0]);
(Sum, [3198; 56]); (Choose (Less 0 1), [3314; 3198; 182; 808]); (Sum, [3315; 81]); (Choose (Less 0 1), [3316; 3315; 182;
1453]); (Sum, [3317; 106]); (Choose (Less 0 1), [3318; 3317; 182; 2082]); (Sum, [3319; 131]); (Choose (Less 0 1), [3320;
3319; 182; 2715]); (Difference, [149; 531]); (Difference, [150; 533])].
Definition from_3150 : list (operation * list N) := [(Difference, [151; 535]); (Product, [3322; 3322]); (Product, [3323;
3323]); (Sum, [3325; 3326]); (Product, [3324; 3324]); (Sum, [3327; 3328]); (Product, [778; 3322]); (Product, [779;
3323]); (Sum, [3330; 3331]); (Product, [780; 3324]); (Sum, [3332; 3333]); (Product, [254; 3329]); (Product, [779;
3322]); (Product, [778; 3323]); (Difference, [3336; 3337]); (Product, [3338; 3338]); (Difference, [3335; 3339]);
(Product, [778; 3324]); (Product, [780; 3322]); (Difference, [3341; 3342]); (Product, [3343; 3343]); (Difference, [3340;
3344]); (Product, [780; 3323]); (Product, [779; 3324]); (Difference, [3346; 3347]); (Product, [3348; 3348]);
(Difference, [3345; 3349]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 3334; 3329; 182;
3350]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6))
(At_most 6 7))) (Less 8 9)), [177; 182; 244; 241; 0; 170; 171; 172; 1; 173; 182; 3351]); (Sum, [3321; 156]); (Choose
(Less 0 1), [3353; 3321; 182; 3352]); (Root, [3329]); (Quotient, [177; 3355]); (Product, [3356; 3322]); (Product, [3356;
3323]); (Product, [3356; 3324]); (Product, [527; 3357]); (Product, [528; 3358]); (Sum, [3360; 3361]); (Product, [529;
3359]); (Sum, [3362; 3363]); (Sum, [3357; 490]); (Sum, [3358; 491]); (Sum, [3359; 492]); (Product, [3365; 3365]);
(Product, [3366; 3366]); (Sum, [3368; 3369]); (Product, [3367; 3367]); (Sum, [3370; 3371]); (Root, [3372])].
Definition from_3200 : list (operation * list N) := [(Product, [527; 3365]); (Product, [528; 3366]); (Sum, [3374;
3375]); (Product, [529; 3367]); (Sum, [3376; 3377]); (Quotient, [3378; 3373]); (Choose (Less 0 1), [3379; 182; 182;
3379]); (Choose (Less 0 1), [3380; 182; 182; 3373]); (Power, [3381; 38]); (Choose (Same 0 1), [3364; 3364; 31; 177]);
(Choose (Same 0 1), [182; 3382; 31; 177]); (Product, [3355; 490]); (Sum, [3385; 3322]); (Product, [3355; 491]); (Sum,
[3387; 3323]); (Product, [3355; 492]); (Sum, [3389; 3324]); (Product, [3386; 3386]); (Product, [3388; 3388]); (Sum,
[3391; 3392]); (Product, [3390; 3390]); (Sum, [3393; 3394]); (Product, [527; 3322]); (Product, [528; 3323]); (Sum,
[3396; 3397]); (Product, [529; 3324]); (Sum, [3398; 3399]); (Product, [527; 3386]); (Product, [528; 3388]); (Sum, [3401;
3402]); (Product, [529; 3390]); (Sum, [3403; 3404]); (Choose (Less 0 1), [3405; 182; 182; 3405]); (Product, [3395;
3355]); (Quotient, [177; 3407]); (Choose (Less 0 1), [3408; 182; 182; 3395]); (Product, [3400; 3395]); (Product, [3410;
3409]); (Choose (Less 0 1), [3411; 873; 182; 3395]); (Product, [3406; 3406]); (Product, [3413; 3355]); (Product, [3414;
3409]); (Power, [3415; 38]); (Choose (Same 0 1), [3412; 3383; 31; 241]); (Choose (Same 0 1), [3416; 3384; 31; 241]);
(Product, [241; 3364]); (Product, [3419; 884]); (Product, [3357; 490]); (Difference, [3420; 3421]); (Product, [3358;
491])].
Definition from_3250 : list (operation * list N) := [(Difference, [3422; 3423]); (Product, [3359; 492]); (Difference,
[3424; 3425]); (Choose (Less 0 1), [3426; 182; 182; 3426]); (Power, [3427; 38]); (Choose (Same 0 1), [3364; 3417; 31;
239]); (Choose (Same 0 1), [3428; 3418; 31; 239]); (Choose (Same 0 1), [3364; 3429; 31; 358]); (Choose (Same 0 1), [182;
3430; 31; 358]); (Choose (Less 0 1), [3381; 182; 182; 3364]); (Power, [3433; 38]); (Choose (Same 0 1), [3364; 3431; 31;
371]); (Choose (Same 0 1), [3434; 3432; 31; 371]); (Choose (Same 0 1), [3364; 3435; 31; 382]); (Choose (Same 0 1), [182;
3436; 31; 382]); (Choose (Less 0 1), [3415; 182; 182; 3412]); (Power, [3439; 38]); (Choose (Same 0 1), [3412; 3437; 31;
400]); (Choose (Same 0 1), [3440; 3438; 31; 400]); (Choose (Less 0 1), [3441; 182; 182; 3441]); (Product, [10; 3443]);
(Product, [11; 3442]); (Product, [15; 3444]); (Sum, [3446; 3445]); (Product, [152; 3447]); (Sum, [3448; 2821]);
(Product, [16; 3444]); (Sum, [3450; 3445]); (Product, [153; 3451]); (Sum, [2822; 3452]); (Product, [17; 3444]); (Sum,
[3454; 3445]); (Product, [154; 3455]); (Sum, [2823; 3456]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less
3 4))) (Less 3 5)), [3449; 2821; 244; 241; 0; 182; 3352; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)), [3453; 2822; 244; 241; 0; 182; 3352; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)), [3457; 2823; 244; 241; 0; 182; 3352; 155]); (Choose (Less 0 1), [3458; 182; 182; 3458]);
(Choose (Less 0 1), [3461; 177; 3461; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3462; 3307; 244; 241; 0]); (Choose
(Less 0 1), [3459; 182; 182; 3459]); (Choose (Less 0 1), [3464; 177; 3464; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[3465; 3310; 244; 241; 0]); (Choose (Less 0 1), [3460; 182; 182; 3460]); (Choose (Less 0 1), [3467; 177; 3467; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [3468; 3313; 244; 241; 0]); (Sum, [3354; 546]); (Choose (Both (Both (Same 0 1)
(Same 2 2)) (Less 3 4)), [3470; 3354; 244; 239; 0; 182; 545]); (Sum, [3471; 56]); (Choose (Less 0 1), [3472; 3471; 182;
995])].
Definition from_3300 : list (operation * list N) := [(Sum, [3473; 81]); (Choose (Less 0 1), [3474; 3473; 182; 1628]);
(Sum, [3475; 106]); (Choose (Less 0 1), [3476; 3475; 182; 2259]); (Sum, [3477; 131]); (Choose (Less 0 1), [3478; 3477;
182; 2894]); (Difference, [149; 0]); (Difference, [150; 1]); (Difference, [151; 182]); (Product, [3480; 3480]);
(Product, [3481; 3481]); (Sum, [3483; 3484]); (Product, [3482; 3482]); (Sum, [3485; 3486]); (Product, [940; 3480]);
(Product, [941; 3481]); (Sum, [3488; 3489]); (Product, [182; 3482]); (Sum, [3490; 3491]); (Product, [254; 3487]);
(Product, [941; 3480]); (Product, [940; 3481]); (Difference, [3494; 3495]); (Product, [3496; 3496]); (Difference, [3493;
3497]); (Product, [940; 3482]); (Product, [182; 3480]); (Difference, [3499; 3500]); (Product, [3501; 3501]);
(Difference, [3498; 3502]); (Product, [182; 3481]); (Product, [941; 3482]); (Difference, [3504; 3505]); (Product, [3506;
3506]); (Difference, [3503; 3507]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 3492; 3487;
182; 3508]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5
6)) (At_most 6 7))) (Less 8 9)), [177; 182; 244; 239; 0; 158; 159; 160; 1; 161; 182; 3509]); (Product, [970; 3480]);
(Product, [971; 3481]); (Sum, [3511; 3512]); (Product, [972; 3482]); (Sum, [3513; 3514]); (Product, [207; 3487]);
(Product, [971; 3480]); (Product, [970; 3481]); (Difference, [3517; 3518]); (Product, [3519; 3519]); (Difference, [3516;
3520]); (Product, [970; 3482]); (Product, [972; 3480])].
Definition from_3350 : list (operation * list N) := [(Difference, [3522; 3523]); (Product, [3524; 3524]); (Difference,
[3521; 3525]); (Product, [972; 3481]); (Product, [971; 3482]); (Difference, [3527; 3528]); (Product, [3529; 3529]);
(Difference, [3526; 3530]); (Choose (Both (Both (Less 0 1) (At_most 2 3)) (Less 2 0)), [177; 182; 3515; 3487; 182;
3531]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Both (Both (Both (At_most 3 2) (At_most 2 4)) (At_most 5 6))
(At_most 6 7))) (Less 8 9)), [177; 3510; 244; 239; 0; 162; 163; 164; 1; 165; 182; 3532]); (Sum, [3479; 156]); (Choose
(Less 0 1), [3534; 3479; 182; 3533]); (Root, [3487]); (Quotient, [177; 3536]); (Product, [3537; 3480]); (Product, [3537;
3481]); (Product, [3537; 3482]); (Product, [182; 3538]); (Product, [182; 3539]); (Sum, [3541; 3542]); (Product, [177;
3540]); (Sum, [3543; 3544]); (Sum, [3538; 490]); (Sum, [3539; 491]); (Sum, [3540; 492]); (Product, [3546; 3546]);
(Product, [3547; 3547]); (Sum, [3549; 3550]); (Product, [3548; 3548]); (Sum, [3551; 3552]); (Root, [3553]); (Product,
[182; 3546]); (Product, [182; 3547]); (Sum, [3555; 3556]); (Product, [177; 3548]); (Sum, [3557; 3558]); (Quotient,
[3559; 3554]); (Choose (Less 0 1), [3560; 182; 182; 3560]); (Choose (Less 0 1), [3561; 182; 182; 3554]); (Power, [3562;
38]); (Choose (Same 0 1), [3545; 3545; 31; 177]); (Choose (Same 0 1), [182; 3563; 31; 177]); (Product, [3536; 490]);
(Sum, [3566; 3480]); (Product, [3536; 491]); (Sum, [3568; 3481]); (Product, [3536; 492]); (Sum, [3570; 3482]); (Product,
[3567; 3567]); (Product, [3569; 3569])].
Definition from_3400 : list (operation * list N) := [(Sum, [3572; 3573]); (Product, [3571; 3571]); (Sum, [3574; 3575]);
(Sum, [3500; 3504]); (Product, [177; 3482]); (Sum, [3577; 3578]); (Product, [182; 3567]); (Product, [182; 3569]); (Sum,
[3580; 3581]); (Product, [177; 3571]); (Sum, [3582; 3583]); (Choose (Less 0 1), [3584; 182; 182; 3584]); (Product,
[3576; 3536]); (Quotient, [177; 3586]); (Choose (Less 0 1), [3587; 182; 182; 3576]); (Product, [3579; 3576]); (Product,
[3589; 3588]); (Choose (Less 0 1), [3590; 1058; 182; 3576]); (Product, [3585; 3585]); (Product, [3592; 3536]); (Product,
[3593; 3588]); (Power, [3594; 38]); (Choose (Same 0 1), [3591; 3564; 31; 241]); (Choose (Same 0 1), [3595; 3565; 31;
241]); (Product, [241; 3545]); (Product, [3598; 1069]); (Product, [3538; 490]); (Difference, [3599; 3600]); (Product,
[3539; 491]); (Difference, [3601; 3602]); (Product, [3540; 492]); (Difference, [3603; 3604]); (Choose (Less 0 1), [3605;
182; 182; 3605]); (Power, [3606; 38]); (Choose (Same 0 1), [3545; 3596; 31; 239]); (Choose (Same 0 1), [3607; 3597; 31;
239]); (Choose (Same 0 1), [3545; 3608; 31; 358]); (Choose (Same 0 1), [182; 3609; 31; 358]); (Choose (Less 0 1), [3562;
182; 182; 3545]); (Power, [3612; 38]); (Choose (Same 0 1), [3545; 3610; 31; 371]); (Choose (Same 0 1), [3613; 3611; 31;
371]); (Choose (Same 0 1), [3545; 3614; 31; 382]); (Choose (Same 0 1), [182; 3615; 31; 382]); (Choose (Less 0 1), [3594;
182; 182; 3591]); (Power, [3618; 38]); (Choose (Same 0 1), [3591; 3616; 31; 400]); (Choose (Same 0 1), [3619; 3617; 31;
400]); (Choose (Less 0 1), [3620; 182; 182; 3620]); (Product, [10; 3622])].
Definition from_3450 : list (operation * list N) := [(Product, [11; 3621]); (Product, [549; 3623]); (Sum, [3625; 3624]);
(Product, [152; 3626]); (Sum, [3627; 2996]); (Product, [153; 3626]); (Sum, [2997; 3629]); (Product, [550; 3623]); (Sum,
[3631; 3624]); (Product, [154; 3632]); (Sum, [2998; 3633]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less
3 4))) (Less 3 5)), [3628; 2996; 244; 239; 0; 182; 3533; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not
(Less 3 4))) (Less 3 5)), [3630; 2997; 244; 239; 0; 182; 3533; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)), [3634; 2998; 244; 239; 0; 182; 3533; 155]); (Choose (Less 0 1), [3635; 182; 182; 3635]);
(Choose (Less 0 1), [3638; 177; 3638; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3639; 3463; 244; 239; 0]); (Choose
(Less 0 1), [3636; 182; 182; 3636]); (Choose (Less 0 1), [3641; 177; 3641; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[3642; 3466; 244; 239; 0]); (Choose (Less 0 1), [3637; 182; 182; 3637]); (Choose (Less 0 1), [3644; 177; 3644; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [3645; 3469; 244; 239; 0]); (Product, [452; 3166]); (Product, [454; 3167]); (Sum,
[3647; 3648]); (Product, [455; 3168]); (Sum, [3649; 3650]); (Sum, [3292; 3016]); (Sum, [3017; 3296]); (Sum, [3018;
3300]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3652; 3016;
244; 177; 0; 182; 3196; 155; 3651]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3
5)) (Less 3 6)), [3653; 3017; 244; 177; 0; 182; 3196; 155; 3651]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2
2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3654; 3018; 244; 177; 0; 182; 3196; 155; 3651]); (Choose (Less 0 1),
[3655; 182; 182; 3655]); (Choose (Less 0 1), [3658; 177; 3658; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3659; 182;
244; 177; 0]); (Choose (Less 0 1), [3656; 182; 182; 3656]); (Choose (Less 0 1), [3661; 177; 3661; 177]); (Choose (Both
(Same 0 1) (Same 2 2)), [3662; 182; 244; 177; 0]); (Choose (Less 0 1), [3657; 182; 182; 3657]); (Choose (Less 0 1),
[3664; 177; 3664; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3665; 182; 244; 177; 0]); (Sum, [3448; 3031]); (Sum,
[3032; 3452]); (Sum, [3033; 3456]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5))
(Less 3 6)), [3667; 3031; 244; 241; 0; 182; 3352; 155; 3400]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3668; 3032; 244; 241; 0; 182; 3352; 155; 3400]); (Choose (Both (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3669; 3033; 244; 241; 0; 182; 3352; 155;
3400]); (Choose (Less 0 1), [3670; 182; 182; 3670])].
Definition from_3500 : list (operation * list N) := [(Choose (Less 0 1), [3673; 177; 3673; 177]); (Choose (Both (Same 0
1) (Same 2 2)), [3674; 3660; 244; 241; 0]); (Choose (Less 0 1), [3671; 182; 182; 3671]); (Choose (Less 0 1), [3676; 177;
3676; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3677; 3663; 244; 241; 0]); (Choose (Less 0 1), [3672; 182; 182;
3672]); (Choose (Less 0 1), [3679; 177; 3679; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3680; 3666; 244; 241; 0]);
(Sum, [3627; 3046]); (Sum, [3047; 3629]); (Sum, [3048; 3633]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2))
(Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3682; 3046; 244; 239; 0; 182; 3533; 155; 3579]); (Choose (Both (Both (Both
(Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3683; 3047; 244; 239; 0; 182; 3533; 155;
3579]); (Choose (Both (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)) (Less 3 6)), [3684; 3048;
244; 239; 0; 182; 3533; 155; 3579]); (Choose (Less 0 1), [3685; 182; 182; 3685]); (Choose (Less 0 1), [3688; 177; 3688;
177]); (Choose (Both (Same 0 1) (Same 2 2)), [3689; 3675; 244; 239; 0]); (Choose (Less 0 1), [3686; 182; 182; 3686]);
(Choose (Less 0 1), [3691; 177; 3691; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3692; 3678; 244; 239; 0]); (Choose
(Less 0 1), [3687; 182; 182; 3687]); (Choose (Less 0 1), [3694; 177; 3694; 177]); (Choose (Both (Same 0 1) (Same 2 2)),
[3695; 3681; 244; 239; 0]); (Product, [612; 3166]); (Product, [613; 3167]); (Sum, [3697; 3698]); (Product, [614; 3168]);
(Sum, [3699; 3700]); (Product, [612; 3230]); (Product, [613; 3232]); (Sum, [3702; 3703]); (Product, [614; 3234]); (Sum,
[3704; 3705]); (Choose (Less 0 1), [3706; 182; 182; 3706]); (Product, [3701; 3239]); (Product, [3708; 3253]); (Choose
(Less 0 1), [3709; 1177; 182; 3239]); (Product, [3707; 3707]); (Product, [3711; 3199]); (Product, [3712; 3253]);
(Product, [3713; 3713]); (Product, [3714; 3714]); (Product, [3715; 3715]); (Product, [3716; 3716]); (Choose (Less 0 1),
[3710; 182; 182; 3710]); (Product, [10; 3718]); (Product, [11; 3717]); (Product, [12; 3719]); (Sum, [3721; 3720]);
(Product, [152; 3722])].
Definition from_3550 : list (operation * list N) := [(Sum, [3723; 3094]); (Product, [13; 3719]); (Sum, [3725; 3720]);
(Product, [153; 3726]); (Sum, [3095; 3727]); (Product, [14; 3719]); (Sum, [3729; 3720]); (Product, [154; 3730]); (Sum,
[3096; 3731]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3724; 3094; 244; 177; 0;
182; 3196; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3728; 3095; 244; 177;
0; 182; 3196; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3732; 3096; 244;
177; 0; 182; 3196; 155]); (Choose (Less 0 1), [3733; 182; 182; 3733]); (Choose (Less 0 1), [3736; 177; 3736; 177]);
(Choose (Both (Same 0 1) (Same 2 2)), [3737; 182; 244; 177; 0]); (Choose (Less 0 1), [3734; 182; 182; 3734]); (Choose
(Less 0 1), [3739; 177; 3739; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3740; 182; 244; 177; 0]); (Choose (Less 0
1), [3735; 182; 182; 3735]); (Choose (Less 0 1), [3742; 177; 3742; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3743;
182; 244; 177; 0]); (Product, [3415; 3415]); (Product, [3745; 3745]); (Product, [3746; 3746]); (Product, [3747; 3747]);
(Choose (Less 0 1), [3412; 182; 182; 3412]); (Product, [10; 3749]); (Product, [11; 3748]); (Product, [15; 3750]); (Sum,
[3752; 3751]); (Product, [152; 3753]); (Sum, [3754; 3125]); (Product, [16; 3750]); (Sum, [3756; 3751]); (Product, [153;
3757]); (Sum, [3126; 3758]); (Product, [17; 3750]); (Sum, [3760; 3751]); (Product, [154; 3761]); (Sum, [3127; 3762]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3755; 3125; 244; 241; 0; 182; 3352;
155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3759; 3126; 244; 241; 0; 182;
3352; 155]); (Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3763; 3127; 244; 241; 0;
182; 3352; 155]); (Choose (Less 0 1), [3764; 182; 182; 3764]); (Choose (Less 0 1), [3767; 177; 3767; 177]); (Choose
(Both (Same 0 1) (Same 2 2)), [3768; 3738; 244; 241; 0]); (Choose (Less 0 1), [3765; 182; 182; 3765]); (Choose (Less 0
1), [3770; 177; 3770; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3771; 3741; 244; 241; 0]); (Choose (Less 0 1),
[3766; 182; 182; 3766])].
Definition from_3600 : list (operation * list N) := [(Choose (Less 0 1), [3773; 177; 3773; 177]); (Choose (Both (Same 0
1) (Same 2 2)), [3774; 3744; 244; 241; 0]); (Product, [3594; 3594]); (Product, [3776; 3776]); (Product, [3777; 3777]);
(Product, [3778; 3778]); (Choose (Less 0 1), [3591; 182; 182; 3591]); (Product, [10; 3780]); (Product, [11; 3779]);
(Product, [549; 3781]); (Sum, [3783; 3782]); (Product, [152; 3784]); (Sum, [3785; 3154]); (Product, [153; 3784]); (Sum,
[3155; 3787]); (Product, [550; 3781]); (Sum, [3789; 3782]); (Product, [154; 3790]); (Sum, [3156; 3791]); (Choose (Both
(Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3786; 3154; 244; 239; 0; 182; 3533; 155]); (Choose
(Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3788; 3155; 244; 239; 0; 182; 3533; 155]);
(Choose (Both (Both (Both (Same 0 1) (Same 2 2)) (Not (Less 3 4))) (Less 3 5)), [3792; 3156; 244; 239; 0; 182; 3533;
155]); (Choose (Less 0 1), [3793; 182; 182; 3793]); (Choose (Less 0 1), [3796; 177; 3796; 177]); (Choose (Both (Same 0
1) (Same 2 2)), [3797; 3769; 244; 239; 0]); (Choose (Less 0 1), [3794; 182; 182; 3794]); (Choose (Less 0 1), [3799; 177;
3799; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3800; 3772; 244; 239; 0]); (Choose (Less 0 1), [3795; 182; 182;
3795]); (Choose (Less 0 1), [3802; 177; 3802; 177]); (Choose (Both (Same 0 1) (Same 2 2)), [3803; 3775; 244; 239; 0])].
Definition lines := concat [from_0; from_50; from_100; from_150; from_200; from_250; from_300; from_350; from_400;
from_450; from_500; from_550; from_600; from_650; from_700; from_750; from_800; from_850; from_900; from_950; from_1000;
from_1050; from_1100; from_1150; from_1200; from_1250; from_1300; from_1350; from_1400; from_1450; from_1500; from_1550;
from_1600; from_1650; from_1700; from_1750; from_1800; from_1850; from_1900; from_1950; from_2000; from_2050; from_2100;
from_2150; from_2200; from_2250; from_2300; from_2350; from_2400; from_2450; from_2500; from_2550; from_2600; from_2650;
from_2700; from_2750; from_2800; from_2850; from_2900; from_2950; from_3000; from_3050; from_3100; from_3150; from_3200;
from_3250; from_3300; from_3350; from_3400; from_3450; from_3500; from_3550; from_3600].
Definition pixel := map (fun line => (fst line, map N.to_nat (snd line))) lines.
End recorded_pixel.
