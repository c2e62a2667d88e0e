# From the project's folder, in its environment:  bash -e tests/examples/height_field/way_in.sh
git apply tests/examples/height_field/entry.patch    # the field's entry, and the figure's place on a page
cp -r tests/examples/height_field/{proofs,book} .    # a theorem, Coq's word for it, a figure, a claim
python -m renderer.generate                          # the kernels, and Coq's definitions
python -m proofs.engine.certificate                  # the new certificate, and those that the entry made stale
python -m pytest verify -q --theorem waves_climb_one_way
python -m verify.coq Waves                           # what Coq says, where it is installed
python -m renderer image --field waves --size 128 --out waves.png
python -m book figures waves
python -m book                                       # every theorem and figure again, the ledger, the pages
