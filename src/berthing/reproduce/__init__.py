"""The paper's figures and claims, made and checked anew."""
