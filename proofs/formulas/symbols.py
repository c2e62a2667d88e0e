"""The names of the chapter's quantities. All are real; lengths are in units of the world, angles in radians."""

from proofs.engine.vectors import real, vector, vectors

# Raster: the pixel in `column` (from the left) and `row` (from the top) of `width` × `height` pixels.
column, row, width, height = real("column row width height")
# Image plane: the floor plane z = 0 seen from the eye E = (0, 0, e); half is its vertical half-extent.
x, y, half = real("x y half")
rho, rho_silhouette = real("rho rho_silhouette")

eye, radius, ball_radius = real("eye radius ball_radius")
ball_on, floor_on = real("ball_on floor_on")
ball_center = vector("ball_center")

# Sphere A: the angles of a point, and the chart.
ANGLES = cos_theta, sin_theta, cos_phi, sin_phi = real("cos_theta sin_theta cos_phi sin_phi")
theta, phi = real("theta phi")
u, v = real("u v")

# The height field h(u, v), its wave numbers and its gradient.
k_u, k_v = real("k_u k_v")
h, h_u, h_v = real("h h_u h_v")
beta, epsilon = real("beta epsilon")

# A visible point P, its unit normal N, the bumped normal, the direction to the eye.
point, normal, bumped, view = vectors("point normal bumped view")

# A light: position, and unit direction towards it.
light, towards = vectors("light towards")
mu, specular_base, specular, shininess = real("mu specular_base specular shininess")

TEX_NAMES = {
    eye: "e",
    radius: "R",
    ball_radius: "R_2",
    rho_silhouette: r"\rho_s",
    cos_theta: r"\cos\theta",
    sin_theta: r"\sin\theta",
    cos_phi: r"\cos\varphi",
    sin_phi: r"\sin\varphi",
    phi: r"\varphi",
    epsilon: r"\varepsilon",
    shininess: "p",
} | {
    part: f"{name}_{axis}"
    for components, name in (
        (ball_center, "C"),
        (point, "P"),
        (normal, "N"),
        (bumped, "N'"),
        (view, r"\hat v"),
        (light, "L"),
        (towards, r"\omega"),
    )
    for part, axis in zip(components, "xyz", strict=True)
}
