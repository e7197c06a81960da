"""Plans in the files of others. Each format is a module with ``write``; ``formats`` lists them."""
