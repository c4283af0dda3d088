// Of a higher room.
