# From the project's folder, in its environment:  bash -e tests/examples/light_model/way_in.sh
git apply tests/examples/light_model/entry.patch     # the model's program, and its entry
cp -r tests/examples/light_model/{proofs,book} .     # a theorem, a claim
python -m renderer.generate                          # the kernels, and Coq's definitions
python -m proofs.engine.certificate                  # the new certificate, and those that the entry made stale
python -m pytest verify -q --theorem smooth_is_lambert
python -m renderer image --model oren_nayar --size 128 --out rough.png
python -m book                                       # every theorem and figure again, the ledger, the pages
