"""The plant: pure physics, scalar functions on named tuples, in SI and radians.

Read it in this order: `signals` (what goes in and out), `atmosphere`, `airdata`, `runge_kutta`, `derivatives` (A and B
from published numbers), and `small_perturbation`, the linear plant; then `attitude`, `earth`, `wind`, `rigid_body`,
`aero`, `propulsion` and `plant`, the nonlinear one. Nothing here reads a file, prints, or knows what an aircraft file
is.
"""
