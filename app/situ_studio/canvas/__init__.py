"""The drawings: applications and scripts as node graphs. The only package that imports NodeGraphQt.

A gesture never changes a document and never NodeGraphQt's model: it becomes an
intent, a pure function makes a new document of it, and showing that document
heals the view (``graph.py``, ``viewer.py``).
"""
