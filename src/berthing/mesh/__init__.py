"""CAD meshes and robot descriptions as unions of convex sets that provably contain them."""
