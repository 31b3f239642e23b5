"""What to cite for the method of shaft lines."""

WITTRICK = (
    "W. H. Wittrick, F. W. Williams: A general algorithm for computing natural frequencies of elastic structures. "
    "Quarterly Journal of Mechanics and Applied Mathematics 24 (1971) 263-284."
)
SIDORIKA = (
    "I. N. Sidorika: dynamic load capacity of the main thrust bearing of a geared-diesel trawler. "
    "Eastern-European "
    "Journal of Enterprise Technologies 4/7 (70) (2014)."
)
