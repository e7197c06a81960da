"""Tables, figures and the plan folder: they show what was found and compute nothing new."""
