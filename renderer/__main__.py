"""Draw from the command line:  python -m renderer image|views|sweep --help"""

import sys

from renderer.command_line import main

sys.exit(main())
