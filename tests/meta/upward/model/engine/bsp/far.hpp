// Of a sibling engine.
