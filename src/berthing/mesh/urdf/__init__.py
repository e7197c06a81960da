"""Robot descriptions: the collision geometry and masses of all links, as one rigid body."""
