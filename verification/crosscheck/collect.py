"""Every comparison there is: the values of the harness against those of reference_data/."""

import cracks
import elastic
import elements
import peers
import sliding
import special
import sphere

SOURCES = (special, cracks, sliding, sphere, elements, elastic, peers)


def everything(harness):
    return [value for source in SOURCES for value in source.values(harness)]
