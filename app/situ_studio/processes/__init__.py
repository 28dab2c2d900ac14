"""Work in processes of the studio's own: worker, the other end of it, what is told of it."""
