tabs-too-many = A project can have at most { $limit } robots.
tabs-one-real = Only one robot can run a program on { $robot }, which is a real robot. Choose a simulated robot for more.
tabs-last = A project needs at least one robot.
tabs-none-closed = No closed robot can be reopened.
tabs-wrong-name = A robot can't be called '{ $name }'. Choose another name of at most { $limit } letters, digits, spaces and hyphens, which no other robot has.
tabs-no-such = This project has no robot '{ $name }'.
tabs-error = The program of '{ $name }' can't run: { $problem }
