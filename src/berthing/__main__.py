"""``python -m berthing``."""

from berthing.cli import main

if __name__ == "__main__":
    main()
