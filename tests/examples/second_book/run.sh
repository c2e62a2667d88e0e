export PYTHONPATH=${TOOLS:-../../..}     # the folder that has proofs/, verify/ and book/
python -m proofs.engine.certificate
python -m book
