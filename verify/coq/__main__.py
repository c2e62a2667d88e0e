"""The command that lets Coq check `proofs/formal/`, and records what it accepted:  python -m verify.coq"""

import sys

from verify.coq.formal import NotAccepted, main

if __name__ == "__main__":
    try:
        main()
    except NotAccepted as error:
        sys.exit(str(error))
