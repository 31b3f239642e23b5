"""Published cases: story, reference, our answer and the figure."""
