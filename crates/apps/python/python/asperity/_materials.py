"""Materials by name, with the source of their numbers."""

from typing import NamedTuple

from asperity import _asperity
from asperity._records import Body


# Annotations are classes, not texts: pdoc does not find the names of texts in named tuples.
class Material(NamedTuple):
    """A material of the list: typical numbers at room temperature, for orientation."""

    #: The name in text, with its condition.
    name: str
    #: Its numbers.
    body: Body
    #: Where they were read.
    source: str


def materials() -> dict[str, Material]:
    """The materials that a scene file or `Body.material` may name.

    >>> import asperity
    >>> steel = asperity.materials()["steel-100cr6"]
    >>> steel.body.hardness, steel.source
    (8165000000.0, 'Lucefin Group, technical card 100Cr6')
    """
    return {key: Material(*found) for key, found in _asperity.materials().items()}
