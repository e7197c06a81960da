"""What each command of the command line does; ``cli`` only names them and their options."""
