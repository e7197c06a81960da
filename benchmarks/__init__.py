"""The measured claims; run one by name: ``python -m benchmarks NAME --json FILE``."""
