"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.

Each `*_row` function runs over the pixels start ≤ i < stop of one row: arguments ending in `_row` are float64 arrays
along the row, the others are scalars, and results are written to the last arrays.
Nothing is compiled: NumPy does the whole row at once.
"""

import math

import numpy as np


def inlined(function):
    return function


compiled = np.errstate(all="ignore")  # a selection computes both of its sides


def pixels(start, stop):
    return (slice(start, stop),)


def power(base, exponent):
    return np.frompyfunc(math.pow, 2, 1)(base, exponent).astype(np.float64)  # NumPy's own may differ in the last bit


@inlined
def atan2pi(ordinate, abscissa):
    larger = np.maximum(np.abs(abscissa), np.abs(ordinate))
    smaller = np.minimum(np.abs(abscissa), np.abs(ordinate))
    middle = np.where((smaller > 0.3125 * larger), 1.0, 0.0)
    steep = np.where((smaller > 0.75 * larger), 1.0, 0.0)
    node = np.where((steep > 0.0), 1.0, np.where((middle > 0.0), 0.5, 0.0))
    node_value = np.where((steep > 0.0), 0.25, np.where((middle > 0.0), 0.14758361765043326, 0.0))
    node_correction = np.where((steep > 0.0), 0.0, np.where((middle > 0.0), 1.1095511164473943e-17, 0.0))
    denominator = larger + node * smaller
    ratio = np.where((larger > 0.0), (-larger * node + smaller) / denominator, 0.0)
    ratio_squared = ratio * ratio
    arctangent_tail = ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (0.010976202971854851 - 0.010268060844638409 * ratio_squared) - 0.011789255043844099) + 0.012732395447351627) - 0.013839560268860464) + 0.015157613627799556) - 0.016753151904410034) + 0.018724110951987685) - 0.021220659078919377) + 0.02448537586029159) - 0.028937262380344605) + 0.035367765131532294) - 0.04547284088339867) + 0.06366197723675814) - 0.10610329539459688) - 1.9678676675182486e-17
    small_part = node_correction + ratio * (arctangent_tail + 0.3183098861837907)
    first_octant = node_value + small_part
    first_quadrant = np.where((np.abs(abscissa) < np.abs(ordinate)), 0.5 - first_octant, first_octant)
    half_plane = np.where((abscissa < 0.0), 1.0 - first_quadrant, first_quadrant)
    angle = np.where((ordinate < 0.0), -half_plane, half_plane)
    return angle


@inlined
def sinpi(product):
    product_error = 0.0
    quarters = np.rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * np.floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    sine = np.where((quadrant < 0.5), sine_near, np.where((quadrant < 1.5), cosine_near, np.where((quadrant < 2.5), -sine_near, -cosine_near)))
    return sine


@inlined
def sinpi_of_product(a, b):
    product = a * b
    a_split = 134217729.0 * a
    a_excess = -a + a_split
    a_high = -a_excess + a_split
    a_low = a - a_high
    b_split = 134217729.0 * b
    b_excess = -b + b_split
    b_high = -b_excess + b_split
    b_low = b - b_high
    error_1 = a_high * b_high - product
    error_2 = a_high * b_low + error_1
    error_3 = a_low * b_high + error_2
    product_error = a_low * b_low + error_3
    quarters = np.rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * np.floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    sine = np.where((quadrant < 0.5), sine_near, np.where((quadrant < 1.5), cosine_near, np.where((quadrant < 2.5), -sine_near, -cosine_near)))
    return sine


@inlined
def cospi(product):
    product_error = 0.0
    quarters = np.rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * np.floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    cosine = np.where((quadrant < 0.5), cosine_near, np.where((quadrant < 1.5), -sine_near, np.where((quadrant < 2.5), -cosine_near, sine_near)))
    return cosine


@inlined
def cospi_of_product(a, b):
    product = a * b
    a_split = 134217729.0 * a
    a_excess = -a + a_split
    a_high = -a_excess + a_split
    a_low = a - a_high
    b_split = 134217729.0 * b
    b_excess = -b + b_split
    b_high = -b_excess + b_split
    b_low = b - b_high
    error_1 = a_high * b_high - product
    error_2 = a_high * b_low + error_1
    error_3 = a_low * b_high + error_2
    product_error = a_low * b_low + error_3
    quarters = np.rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * np.floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    cosine = np.where((quadrant < 0.5), cosine_near, np.where((quadrant < 1.5), -sine_near, np.where((quadrant < 2.5), -cosine_near, sine_near)))
    return cosine


@compiled
def discriminant_of_a(x, y, eye, radius):
    rho_raw = np.sqrt(x * x + y * y)
    rho = np.where((rho_raw >= (1.0 / 1e+150) * eye), rho_raw, 0.0)
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / np.sqrt(tangent_squared)
    discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette)
    return discriminant_a


def image_extent(eye, radius):
    tangent_squared = (eye - radius) * (eye + radius)
    half = 1.25 * eye * radius / np.sqrt(tangent_squared)
    return half


def image_x(column, width, height, half):
    x = half * (2.0 * column - width + 1.0) / height
    return x


def image_y(row, height, half):
    y = half * ((-3.0 / 20.0) + (height - 2.0 * row - 1.0) / height)
    return y


def tangent_interval(apex, apex_height, center, center_height, sphere_radius, level):
    across = -apex + center
    drop = apex_height - center_height
    spread = sphere_radius * np.sqrt(across * across + (drop - sphere_radius) * (drop + sphere_radius))
    slope_low = (across * drop - spread) / ((drop - sphere_radius) * (drop + sphere_radius))
    slope_high = (across * drop + spread) / ((drop - sphere_radius) * (drop + sphere_radius))
    low = apex + slope_low * (apex_height - level)
    high = apex + slope_high * (apex_height - level)
    return low, high


def shadow_clearance(light_x, light_y, light_z, center_x, center_y, center_z, body_radius, ball_center_x, ball_center_y, ball_center_z, ball_radius):
    from_body_x = -center_x + light_x
    from_body_y = -center_y + light_y
    from_body_z = -center_z + light_z
    along_x = ball_center_x - light_x
    along_y = ball_center_y - light_y
    along_z = ball_center_z - light_z
    at_light = -body_radius * body_radius + from_body_x * from_body_x + from_body_y * from_body_y + from_body_z * from_body_z
    half_slope = along_x * from_body_x + along_y * from_body_y + along_z * from_body_z - ball_radius * body_radius
    curvature = along_x * along_x + along_y * along_y + along_z * along_z - ball_radius * ball_radius
    turning = np.where((half_slope >= 0.0), 0.0, np.where((curvature + half_slope <= 0.0), 1.0, -half_slope / curvature))
    at_ball = at_light + curvature + 2.0 * half_slope
    at_turning = at_light + turning * (curvature * turning + 2.0 * half_slope)
    at_an_end = np.where((at_ball < at_light), at_ball, at_light)
    shortest = np.where((at_an_end > at_turning), at_turning, at_an_end)
    clearance = shortest / (along_x * along_x + along_y * along_y + along_z * along_z + from_body_x * from_body_x + from_body_y * from_body_y + from_body_z * from_body_z)
    return clearance


def ambient_term(ka, ambient):
    color = ambient * ka
    return color


def floor_albedo(floor_dark, floor_tint):
    floor_base = np.where((floor_dark > 0.0), (3.0 / 20.0), (17.0 / 20.0))
    floor_red = floor_base * (1.0 - floor_tint)
    floor_blue = floor_base
    return floor_red, floor_blue


@compiled
def visible_surface_row(
    x_row, y, eye, radius, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, floor_on,
    surface_row, start, stop
):
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / np.sqrt(tangent_squared)
    distance = -ball_center_z + eye
    t_floor = np.where((floor_on > 0.0), 1.0, np.inf)
    for i in pixels(start, stop):
        x = x_row[i]
        rho_raw = np.sqrt(x * x + y * y)
        rho = np.where((rho_raw >= (1.0 / 1e+150) * eye), rho_raw, 0.0)
        discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette)
        root_a = np.sqrt(np.maximum(0.0, discriminant_a))
        t_a = np.where((discriminant_a >= 0.0), tangent_squared / (eye * eye + root_a), np.inf)
        toward_b = ball_center_x * x + ball_center_y * y + distance * eye
        discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y)
        root_b = np.sqrt(np.maximum(0.0, discriminant_b))
        t_b = np.where(((ball_on > 0.0) & (discriminant_b >= 0.0) & (toward_b > 0.0)), (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b), np.inf)
        surface = np.where(((t_a < np.inf) & (t_a <= t_b) & (t_a <= t_floor)), 1.0, np.where(((t_b < np.inf) & (t_b <= t_floor)), 2.0, np.where((t_floor < np.inf), 3.0, 0.0)))
        surface_row[i] = surface


@compiled
def shadow_on_a_row(
    x_row, y, eye, radius, light_x, light_y, light_z, center_x, center_y, center_z, body_radius,
    occluded_row, start, stop
):
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / np.sqrt(tangent_squared)
    for i in pixels(start, stop):
        x = x_row[i]
        rho_raw = np.sqrt(x * x + y * y)
        rho = np.where((rho_raw >= (1.0 / 1e+150) * eye), rho_raw, 0.0)
        discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette)
        root_a = np.sqrt(np.maximum(0.0, discriminant_a))
        rho_inverse = np.where((rho > 0.0), 1.0 / rho, 0.0)
        hit_scale = 1.0 / (radius * (eye * eye + root_a))
        cos_theta = rho_inverse * x
        sin_theta = rho_inverse * y
        sin_phi = hit_scale * rho * tangent_squared
        cos_phi = eye * hit_scale * (radius * radius + root_a)
        point_x = cos_theta * radius * sin_phi
        point_y = radius * sin_phi * sin_theta
        point_z = cos_phi * radius
        segment_x = light_x - point_x
        segment_y = light_y - point_y
        segment_z = light_z - point_z
        offset_x = center_x - point_x
        offset_y = center_y - point_y
        offset_z = center_z - point_z
        segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z
        toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z
        shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y)
        occluded = np.where(((segment_squared > toward_center) & (shadow_discriminant >= 0.0) & (toward_center > 0.0)), 1.0, 0.0)
        occluded_row[i] = occluded


@compiled
def shadow_on_b_row(
    x_row, y, eye, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, light_x, light_y,
    light_z, center_x, center_y, center_z, body_radius, occluded_row, start, stop
):
    distance = -ball_center_z + eye
    for i in pixels(start, stop):
        x = x_row[i]
        toward_b = ball_center_x * x + ball_center_y * y + distance * eye
        discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y)
        root_b = np.sqrt(np.maximum(0.0, discriminant_b))
        t_b = np.where(((ball_on > 0.0) & (discriminant_b >= 0.0) & (toward_b > 0.0)), (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b), np.inf)
        point_x = t_b * x
        point_y = t_b * y
        point_z = eye * (1.0 - t_b)
        segment_x = light_x - point_x
        segment_y = light_y - point_y
        segment_z = light_z - point_z
        offset_x = center_x - point_x
        offset_y = center_y - point_y
        offset_z = center_z - point_z
        segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z
        toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z
        shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y)
        occluded = np.where(((segment_squared > toward_center) & (shadow_discriminant >= 0.0) & (toward_center > 0.0)), 1.0, 0.0)
        occluded_row[i] = occluded


@compiled
def shadow_on_floor_row(
    x_row, y, light_x, light_y, light_z, center_x, center_y, center_z, body_radius, occluded_row, start, stop
):
    point_y = y
    point_z = 0.0
    segment_y = light_y - point_y
    segment_z = light_z - point_z
    offset_y = center_y - point_y
    offset_z = center_z - point_z
    for i in pixels(start, stop):
        x = x_row[i]
        point_x = x
        segment_x = light_x - point_x
        offset_x = center_x - point_x
        segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z
        toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z
        shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y)
        occluded = np.where(((segment_squared > toward_center) & (shadow_discriminant >= 0.0) & (toward_center > 0.0)), 1.0, 0.0)
        occluded_row[i] = occluded


@compiled
def checker_row(
    x_row, y, dark_row, start, stop
):
    point_y = y
    for i in pixels(start, stop):
        x = x_row[i]
        point_x = x
        square = np.floor(point_x) + np.floor(point_y)
        dark = np.where(((point_x != np.floor(point_x)) & (point_y != np.floor(point_y)) & (square != 2.0 * np.floor(0.5 * square))), 1.0, 0.0)
        dark_row[i] = dark


@compiled
def angles_on_a_row(
    x_row, y, eye, radius, cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, start, stop
):
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / np.sqrt(tangent_squared)
    for i in pixels(start, stop):
        x = x_row[i]
        rho_raw = np.sqrt(x * x + y * y)
        rho = np.where((rho_raw >= (1.0 / 1e+150) * eye), rho_raw, 0.0)
        discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette)
        root_a = np.sqrt(np.maximum(0.0, discriminant_a))
        rho_inverse = np.where((rho > 0.0), 1.0 / rho, 0.0)
        hit_scale = 1.0 / (radius * (eye * eye + root_a))
        cos_theta = rho_inverse * x
        sin_theta = rho_inverse * y
        sin_phi = hit_scale * rho * tangent_squared
        cos_phi = eye * hit_scale * (radius * radius + root_a)
        cos_theta_row[i] = cos_theta
        sin_theta_row[i] = sin_theta
        cos_phi_row[i] = cos_phi
        sin_phi_row[i] = sin_phi


@compiled
def chart_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, u_row, v_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        u_closed = 0.5 * atan2pi(sin_theta, cos_theta) + 0.5
        u = np.where((u_closed < 1.0), u_closed, 0.0)
        v = atan2pi(sin_phi, cos_phi)
        u_row[i] = u
        v_row[i] = v


@compiled
def chart_v_row(
    cos_phi_row, sin_phi_row, v_row, start, stop
):
    for i in pixels(start, stop):
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        v = atan2pi(sin_phi, cos_phi)
        v_row[i] = v


@compiled
def normal_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    point_x_row, point_y_row, point_z_row, bumped_x_row, bumped_y_row, bumped_z_row, view_scale_row, start,
    stop
):
    e_theta_z = 0.0
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        normal_z = cos_phi
        e_theta_x = -sin_theta
        e_theta_y = cos_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = e_phi_y * h_v + e_theta_y * h_u
        g_z = e_phi_z * h_v + e_theta_z * h_u
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + normal_z
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = normal_z * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        point_x_row[i] = point_x
        point_y_row[i] = point_y
        point_z_row[i] = point_z
        bumped_x_row[i] = bumped_x
        bumped_y_row[i] = bumped_y
        bumped_z_row[i] = bumped_z
        view_scale_row[i] = view_scale


@compiled
def normal_of_b_row(
    x_row, y, eye, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, point_x_row,
    point_y_row, point_z_row, bumped_x_row, bumped_y_row, bumped_z_row, view_scale_row, start, stop
):
    distance = -ball_center_z + eye
    for i in pixels(start, stop):
        x = x_row[i]
        toward_b = ball_center_x * x + ball_center_y * y + distance * eye
        discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y)
        root_b = np.sqrt(np.maximum(0.0, discriminant_b))
        t_b = np.where(((ball_on > 0.0) & (discriminant_b >= 0.0) & (toward_b > 0.0)), (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b), np.inf)
        point_x = t_b * x
        point_y = t_b * y
        point_z = eye * (1.0 - t_b)
        radius_vector_x = -ball_center_x + point_x
        radius_vector_y = -ball_center_y + point_y
        radius_vector_z = -ball_center_z + point_z
        radius_length = np.sqrt(radius_vector_x * radius_vector_x + radius_vector_y * radius_vector_y + radius_vector_z * radius_vector_z)
        normal_x = radius_vector_x / radius_length
        normal_y = radius_vector_y / radius_length
        normal_z = radius_vector_z / radius_length
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        point_x_row[i] = point_x
        point_y_row[i] = point_y
        point_z_row[i] = point_z
        bumped_x_row[i] = normal_x
        bumped_y_row[i] = normal_y
        bumped_z_row[i] = normal_z
        view_scale_row[i] = view_scale


@compiled
def view_length_row(
    x_row, y, eye, view_scale_row, start, stop
):
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_scale_row[i] = view_scale


@compiled
def complex_square_row(
    real_part_row, imaginary_part_row, start, stop
):
    for i in pixels(start, stop):
        real_part = real_part_row[i]
        imaginary_part = imaginary_part_row[i]
        product_real = (-imaginary_part + real_part) * (imaginary_part + real_part)
        product_imaginary = 2.0 * imaginary_part * real_part
        real_part_row[i] = product_real
        imaginary_part_row[i] = product_imaginary


@compiled
def complex_square_twice_row(
    real_part_row, imaginary_part_row, start, stop
):
    for i in pixels(start, stop):
        real_part = real_part_row[i]
        imaginary_part = imaginary_part_row[i]
        product_real_once = (-imaginary_part + real_part) * (imaginary_part + real_part)
        product_imaginary_once = 2.0 * imaginary_part * real_part
        product_real = (-product_imaginary_once + product_real_once) * (product_imaginary_once + product_real_once)
        product_imaginary = 2.0 * product_imaginary_once * product_real_once
        real_part_row[i] = product_real
        imaginary_part_row[i] = product_imaginary


@compiled
def complex_product_row(
    real_part_row, imaginary_part_row, other_real_row, other_imaginary_row, start, stop
):
    for i in pixels(start, stop):
        real_part = real_part_row[i]
        imaginary_part = imaginary_part_row[i]
        other_real = other_real_row[i]
        other_imaginary = other_imaginary_row[i]
        product_real = -imaginary_part * other_imaginary + other_real * real_part
        product_imaginary = imaginary_part * other_real + other_imaginary * real_part
        real_part_row[i] = product_real
        imaginary_part_row[i] = product_imaginary


@compiled
def square_row(
    base_row, start, stop
):
    for i in pixels(start, stop):
        base = base_row[i]
        power = base * base
        base_row[i] = power


@compiled
def sixteenth_power_row(
    base_row, start, stop
):
    for i in pixels(start, stop):
        base = base_row[i]
        second = base * base
        fourth = second * second
        eighth = fourth * fourth
        power = eighth * eighth
        base_row[i] = power


@compiled
def multiply_row(
    specular_row, base_row, start, stop
):
    for i in pixels(start, stop):
        specular = specular_row[i]
        base = base_row[i]
        power = base * specular
        specular_row[i] = power


@compiled
def blinn_row(
    x_row, y, eye, view_scale_row, point_x_row, point_y_row, point_z_row, light_x, light_y, light_z,
    bumped_x_row, bumped_y_row, bumped_z_row, mu_row, specular_base_row, start, stop
):
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        point_x = point_x_row[i]
        point_y = point_y_row[i]
        point_z = point_z_row[i]
        bumped_x = bumped_x_row[i]
        bumped_y = bumped_y_row[i]
        bumped_z = bumped_z_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - point_x
        to_light_y = light_y - point_y
        to_light_z = light_z - point_z
        light_distance = np.sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
        light_scale = 1.0 / light_distance
        towards_x = light_scale * to_light_x
        towards_y = light_scale * to_light_y
        towards_z = light_scale * to_light_z
        mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
        halfway_x = towards_x + view_x
        halfway_y = towards_y + view_y
        halfway_z = towards_z + view_z
        halfway_length = np.sqrt(halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z)
        specular_base = np.where((halfway_length > 0.0), np.maximum(0.0, (bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z) / halfway_length), 0.0)
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def blinn_on_floor_row(
    x_row, y, eye, view_scale_row, light_x, light_y, light_z, mu_row, specular_base_row, start, stop
):
    to_light_y = light_y - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - x
        light_distance = np.sqrt(light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y)
        light_scale = 1.0 / light_distance
        towards_x = light_scale * to_light_x
        towards_y = light_scale * to_light_y
        towards_z = light_scale * light_z
        mu = towards_z
        halfway_x = towards_x + view_x
        halfway_y = towards_y + view_y
        halfway_z = towards_z + view_z
        halfway_length = np.sqrt(halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z)
        specular_base = np.where((halfway_length > 0.0), np.maximum(0.0, halfway_z / halfway_length), 0.0)
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def phong_row(
    x_row, y, eye, view_scale_row, point_x_row, point_y_row, point_z_row, light_x, light_y, light_z,
    bumped_x_row, bumped_y_row, bumped_z_row, mu_row, specular_base_row, start, stop
):
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        point_x = point_x_row[i]
        point_y = point_y_row[i]
        point_z = point_z_row[i]
        bumped_x = bumped_x_row[i]
        bumped_y = bumped_y_row[i]
        bumped_z = bumped_z_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - point_x
        to_light_y = light_y - point_y
        to_light_z = light_z - point_z
        light_distance = np.sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
        light_scale = 1.0 / light_distance
        towards_x = light_scale * to_light_x
        towards_y = light_scale * to_light_y
        towards_z = light_scale * to_light_z
        mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
        specular_base = np.maximum(0.0, 2.0 * mu * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x * view_x - towards_y * view_y - towards_z * view_z)
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def phong_on_floor_row(
    x_row, y, eye, view_scale_row, light_x, light_y, light_z, mu_row, specular_base_row, start, stop
):
    to_light_y = light_y - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - x
        light_distance = np.sqrt(light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y)
        light_scale = 1.0 / light_distance
        towards_x = light_scale * to_light_x
        towards_y = light_scale * to_light_y
        towards_z = light_scale * light_z
        mu = towards_z
        specular_base = np.maximum(0.0, 2.0 * mu * view_z - towards_x * view_x - towards_y * view_y - towards_z * view_z)
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def blinn_squared_row(
    x_row, y, eye, view_scale_row, point_x_row, point_y_row, point_z_row, light_x, light_y, light_z,
    bumped_x_row, bumped_y_row, bumped_z_row, mu_row, specular_base_row, start, stop
):
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        point_x = point_x_row[i]
        point_y = point_y_row[i]
        point_z = point_z_row[i]
        bumped_x = bumped_x_row[i]
        bumped_y = bumped_y_row[i]
        bumped_z = bumped_z_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - point_x
        to_light_y = light_y - point_y
        to_light_z = light_z - point_z
        distance_squared = to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z
        light_distance = np.sqrt(distance_squared)
        halfway_x = light_distance * view_x + to_light_x
        halfway_y = light_distance * view_y + to_light_y
        halfway_z = light_distance * view_z + to_light_z
        halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z
        along_light = bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z
        along_halfway = np.maximum(0.0, bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z)
        light_scale = np.where((halfway_squared > 0.0), 1.0 / (halfway_squared * light_distance), 0.0)
        mu = np.where((halfway_squared > 0.0), along_light * halfway_squared * light_scale, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
        specular_base = along_halfway * along_halfway * light_distance * light_scale
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def blinn_squared_on_floor_row(
    x_row, y, eye, view_scale_row, light_x, light_y, light_z, mu_row, specular_base_row, start, stop
):
    to_light_y = light_y - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = view_scale_row[i]
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x = light_x - x
        distance_squared = light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y
        light_distance = np.sqrt(distance_squared)
        halfway_x = light_distance * view_x + to_light_x
        halfway_y = light_distance * view_y + to_light_y
        halfway_z = light_distance * view_z + light_z
        halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z
        along_halfway = np.maximum(0.0, halfway_z)
        light_scale = np.where((halfway_squared > 0.0), 1.0 / (halfway_squared * light_distance), 0.0)
        mu = np.where((halfway_squared > 0.0), halfway_squared * light_scale * light_z, -view_z)
        specular_base = along_halfway * along_halfway * light_distance * light_scale
        mu_row[i] = mu
        specular_base_row[i] = specular_base


@compiled
def light_cosine_row(
    point_x_row, point_y_row, point_z_row, light_x, light_y, light_z, bumped_x_row, bumped_y_row,
    bumped_z_row, mu_row, start, stop
):
    for i in pixels(start, stop):
        point_x = point_x_row[i]
        point_y = point_y_row[i]
        point_z = point_z_row[i]
        bumped_x = bumped_x_row[i]
        bumped_y = bumped_y_row[i]
        bumped_z = bumped_z_row[i]
        to_light_x = light_x - point_x
        to_light_y = light_y - point_y
        to_light_z = light_z - point_z
        light_distance = np.sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
        light_scale = 1.0 / light_distance
        towards_x = light_scale * to_light_x
        towards_y = light_scale * to_light_y
        towards_z = light_scale * to_light_z
        mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
        mu_row[i] = mu


@compiled
def light_cosine_on_floor_row(
    x_row, y, light_x, light_y, light_z, mu_row, start, stop
):
    to_light_y = light_y - y
    for i in pixels(start, stop):
        x = x_row[i]
        to_light_x = light_x - x
        light_distance = np.sqrt(light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y)
        light_scale = 1.0 / light_distance
        towards_z = light_scale * light_z
        mu = towards_z
        mu_row[i] = mu


@compiled
def highlight_row(
    specular_base_row, shininess, specular_row, start, stop
):
    for i in pixels(start, stop):
        specular_base = specular_base_row[i]
        specular = power(specular_base, shininess)
        specular_row[i] = specular


@compiled
def light_term_row(
    red_row, green_row, blue_row, light_red, light_green, light_blue, albedo_red, albedo_green, albedo_blue,
    kd, ks, mu_row, specular_row, start, stop
):
    for i in pixels(start, stop):
        red = red_row[i]
        green = green_row[i]
        blue = blue_row[i]
        mu = mu_row[i]
        specular = specular_row[i]
        diffuse = kd * np.maximum(0.0, mu)
        shine = ks * specular
        lit_red = light_red * (albedo_red * diffuse + shine) + red
        lit_green = green + light_green * (albedo_green * diffuse + shine)
        lit_blue = blue + light_blue * (albedo_blue * diffuse + shine)
        red_row[i] = lit_red
        green_row[i] = lit_green
        blue_row[i] = lit_blue


@compiled
def diffuse_term_row(
    red_row, green_row, blue_row, light_red, light_green, light_blue, albedo_red, albedo_green, albedo_blue,
    kd, mu_row, start, stop
):
    for i in pixels(start, stop):
        red = red_row[i]
        green = green_row[i]
        blue = blue_row[i]
        mu = mu_row[i]
        diffuse = kd * np.maximum(0.0, mu)
        lit_red = albedo_red * diffuse * light_red + red
        lit_green = albedo_green * diffuse * light_green + green
        lit_blue = albedo_blue * diffuse * light_blue + blue
        red_row[i] = lit_red
        green_row[i] = lit_green
        blue_row[i] = lit_blue


@compiled
def clip_row(
    red_row, green_row, blue_row, lit_red_row, lit_green_row, lit_blue_row, start, stop
):
    for i in pixels(start, stop):
        red = red_row[i]
        green = green_row[i]
        blue = blue_row[i]
        lit_red = np.minimum(1.0, np.maximum(0.0, red))
        lit_green = np.minimum(1.0, np.maximum(0.0, green))
        lit_blue = np.minimum(1.0, np.maximum(0.0, blue))
        lit_red_row[i] = lit_red
        lit_green_row[i] = lit_green
        lit_blue_row[i] = lit_blue


@compiled
def slope_row(
    h_u_row, h_v_row, slope_row, start, stop
):
    for i in pixels(start, stop):
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        slope = np.sqrt(h_u * h_u + h_v * h_v)
        slope_row[i] = slope


@compiled
def dull_of_1_on_floor_row(
    x_row, y, light_x_1, light_y_1, light_z_1, mu_1_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    for i in pixels(start, stop):
        x = x_row[i]
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        mu_1_row[i] = mu_1


@compiled
def dull_of_2_on_floor_row(
    x_row, y, light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, mu_2_row, start,
    stop
):
    to_light_y_1 = light_y_1 - y
    to_light_y_2 = light_y_2 - y
    for i in pixels(start, stop):
        x = x_row[i]
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        to_light_x_2 = light_x_2 - x
        light_distance_2 = np.sqrt(light_z_2 * light_z_2 + to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_z_2 = light_scale_2 * light_z_2
        mu_2 = towards_z_2
        mu_1_row[i] = mu_1
        mu_2_row[i] = mu_2


@compiled
def blinn_of_1_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        halfway_x_1 = towards_x_1 + view_x
        halfway_y_1 = towards_y_1 + view_y
        halfway_z_1 = towards_z_1 + view_z
        halfway_length_1 = np.sqrt(halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1)
        specular_base_1 = np.where((halfway_length_1 > 0.0), np.maximum(0.0, halfway_z_1 / halfway_length_1), 0.0)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def blinn_of_2_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row,
    specular_base_1_row, mu_2_row, specular_base_2_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    to_light_y_2 = light_y_2 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        halfway_x_1 = towards_x_1 + view_x
        halfway_y_1 = towards_y_1 + view_y
        halfway_z_1 = towards_z_1 + view_z
        halfway_length_1 = np.sqrt(halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1)
        specular_base_1 = np.where((halfway_length_1 > 0.0), np.maximum(0.0, halfway_z_1 / halfway_length_1), 0.0)
        to_light_x_2 = light_x_2 - x
        light_distance_2 = np.sqrt(light_z_2 * light_z_2 + to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_x_2 = light_scale_2 * to_light_x_2
        towards_y_2 = light_scale_2 * to_light_y_2
        towards_z_2 = light_scale_2 * light_z_2
        mu_2 = towards_z_2
        halfway_x_2 = towards_x_2 + view_x
        halfway_y_2 = towards_y_2 + view_y
        halfway_z_2 = towards_z_2 + view_z
        halfway_length_2 = np.sqrt(halfway_x_2 * halfway_x_2 + halfway_y_2 * halfway_y_2 + halfway_z_2 * halfway_z_2)
        specular_base_2 = np.where((halfway_length_2 > 0.0), np.maximum(0.0, halfway_z_2 / halfway_length_2), 0.0)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def phong_of_1_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        specular_base_1 = np.maximum(0.0, 2.0 * mu_1 * view_z - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def phong_of_2_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row,
    specular_base_1_row, mu_2_row, specular_base_2_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    to_light_y_2 = light_y_2 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        light_distance_1 = np.sqrt(light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * light_z_1
        mu_1 = towards_z_1
        specular_base_1 = np.maximum(0.0, 2.0 * mu_1 * view_z - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z)
        to_light_x_2 = light_x_2 - x
        light_distance_2 = np.sqrt(light_z_2 * light_z_2 + to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_x_2 = light_scale_2 * to_light_x_2
        towards_y_2 = light_scale_2 * to_light_y_2
        towards_z_2 = light_scale_2 * light_z_2
        mu_2 = towards_z_2
        specular_base_2 = np.maximum(0.0, 2.0 * mu_2 * view_z - towards_x_2 * view_x - towards_y_2 * view_y - towards_z_2 * view_z)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def squared_of_1_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        distance_squared_1 = light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1
        light_distance_1 = np.sqrt(distance_squared_1)
        halfway_x_1 = light_distance_1 * view_x + to_light_x_1
        halfway_y_1 = light_distance_1 * view_y + to_light_y_1
        halfway_z_1 = light_distance_1 * view_z + light_z_1
        halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1
        along_halfway_1 = np.maximum(0.0, halfway_z_1)
        light_scale_1 = np.where((halfway_squared_1 > 0.0), 1.0 / (halfway_squared_1 * light_distance_1), 0.0)
        mu_1 = np.where((halfway_squared_1 > 0.0), halfway_squared_1 * light_scale_1 * light_z_1, -view_z)
        specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def squared_of_2_on_floor_row(
    x_row, y, eye, light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row,
    specular_base_1_row, mu_2_row, specular_base_2_row, start, stop
):
    to_light_y_1 = light_y_1 - y
    to_light_y_2 = light_y_2 - y
    for i in pixels(start, stop):
        x = x_row[i]
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - x
        distance_squared_1 = light_z_1 * light_z_1 + to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1
        light_distance_1 = np.sqrt(distance_squared_1)
        halfway_x_1 = light_distance_1 * view_x + to_light_x_1
        halfway_y_1 = light_distance_1 * view_y + to_light_y_1
        halfway_z_1 = light_distance_1 * view_z + light_z_1
        halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1
        along_halfway_1 = np.maximum(0.0, halfway_z_1)
        light_scale_1 = np.where((halfway_squared_1 > 0.0), 1.0 / (halfway_squared_1 * light_distance_1), 0.0)
        mu_1 = np.where((halfway_squared_1 > 0.0), halfway_squared_1 * light_scale_1 * light_z_1, -view_z)
        specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1
        to_light_x_2 = light_x_2 - x
        distance_squared_2 = light_z_2 * light_z_2 + to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2
        light_distance_2 = np.sqrt(distance_squared_2)
        halfway_x_2 = light_distance_2 * view_x + to_light_x_2
        halfway_y_2 = light_distance_2 * view_y + to_light_y_2
        halfway_z_2 = light_distance_2 * view_z + light_z_2
        halfway_squared_2 = halfway_x_2 * halfway_x_2 + halfway_y_2 * halfway_y_2 + halfway_z_2 * halfway_z_2
        along_halfway_2 = np.maximum(0.0, halfway_z_2)
        light_scale_2 = np.where((halfway_squared_2 > 0.0), 1.0 / (halfway_squared_2 * light_distance_2), 0.0)
        mu_2 = np.where((halfway_squared_2 > 0.0), halfway_squared_2 * light_scale_2 * light_z_2, -view_z)
        specular_base_2 = along_halfway_2 * along_halfway_2 * light_distance_2 * light_scale_2
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def dull_of_1_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, light_x_1,
    light_y_1, light_z_1, mu_1_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        mu_1_row[i] = mu_1


@compiled
def dull_of_2_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, light_x_1,
    light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, mu_2_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        to_light_x_2 = light_x_2 - point_x
        to_light_y_2 = light_y_2 - point_y
        to_light_z_2 = light_z_2 - point_z
        light_distance_2 = np.sqrt(to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_x_2 = light_scale_2 * to_light_x_2
        towards_y_2 = light_scale_2 * to_light_y_2
        towards_z_2 = light_scale_2 * to_light_z_2
        mu_2 = bumped_x * towards_x_2 + bumped_y * towards_y_2 + bumped_z * towards_z_2
        mu_1_row[i] = mu_1
        mu_2_row[i] = mu_2


@compiled
def blinn_of_1_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        halfway_x_1 = towards_x_1 + view_x
        halfway_y_1 = towards_y_1 + view_y
        halfway_z_1 = towards_z_1 + view_z
        halfway_length_1 = np.sqrt(halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1)
        specular_base_1 = np.where((halfway_length_1 > 0.0), np.maximum(0.0, (bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1) / halfway_length_1), 0.0)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def blinn_of_2_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, specular_base_1_row,
    mu_2_row, specular_base_2_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        halfway_x_1 = towards_x_1 + view_x
        halfway_y_1 = towards_y_1 + view_y
        halfway_z_1 = towards_z_1 + view_z
        halfway_length_1 = np.sqrt(halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1)
        specular_base_1 = np.where((halfway_length_1 > 0.0), np.maximum(0.0, (bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1) / halfway_length_1), 0.0)
        to_light_x_2 = light_x_2 - point_x
        to_light_y_2 = light_y_2 - point_y
        to_light_z_2 = light_z_2 - point_z
        light_distance_2 = np.sqrt(to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_x_2 = light_scale_2 * to_light_x_2
        towards_y_2 = light_scale_2 * to_light_y_2
        towards_z_2 = light_scale_2 * to_light_z_2
        mu_2 = bumped_x * towards_x_2 + bumped_y * towards_y_2 + bumped_z * towards_z_2
        halfway_x_2 = towards_x_2 + view_x
        halfway_y_2 = towards_y_2 + view_y
        halfway_z_2 = towards_z_2 + view_z
        halfway_length_2 = np.sqrt(halfway_x_2 * halfway_x_2 + halfway_y_2 * halfway_y_2 + halfway_z_2 * halfway_z_2)
        specular_base_2 = np.where((halfway_length_2 > 0.0), np.maximum(0.0, (bumped_x * halfway_x_2 + bumped_y * halfway_y_2 + bumped_z * halfway_z_2) / halfway_length_2), 0.0)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def phong_of_1_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        specular_base_1 = np.maximum(0.0, 2.0 * mu_1 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def phong_of_2_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, specular_base_1_row,
    mu_2_row, specular_base_2_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        light_distance_1 = np.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1)
        light_scale_1 = 1.0 / light_distance_1
        towards_x_1 = light_scale_1 * to_light_x_1
        towards_y_1 = light_scale_1 * to_light_y_1
        towards_z_1 = light_scale_1 * to_light_z_1
        mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1
        specular_base_1 = np.maximum(0.0, 2.0 * mu_1 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z)
        to_light_x_2 = light_x_2 - point_x
        to_light_y_2 = light_y_2 - point_y
        to_light_z_2 = light_z_2 - point_z
        light_distance_2 = np.sqrt(to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2)
        light_scale_2 = 1.0 / light_distance_2
        towards_x_2 = light_scale_2 * to_light_x_2
        towards_y_2 = light_scale_2 * to_light_y_2
        towards_z_2 = light_scale_2 * to_light_z_2
        mu_2 = bumped_x * towards_x_2 + bumped_y * towards_y_2 + bumped_z * towards_z_2
        specular_base_2 = np.maximum(0.0, 2.0 * mu_2 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_2 * view_x - towards_y_2 * view_y - towards_z_2 * view_z)
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def squared_of_1_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        distance_squared_1 = to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1
        light_distance_1 = np.sqrt(distance_squared_1)
        halfway_x_1 = light_distance_1 * view_x + to_light_x_1
        halfway_y_1 = light_distance_1 * view_y + to_light_y_1
        halfway_z_1 = light_distance_1 * view_z + to_light_z_1
        halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1
        along_light_1 = bumped_x * to_light_x_1 + bumped_y * to_light_y_1 + bumped_z * to_light_z_1
        along_halfway_1 = np.maximum(0.0, bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1)
        light_scale_1 = np.where((halfway_squared_1 > 0.0), 1.0 / (halfway_squared_1 * light_distance_1), 0.0)
        mu_1 = np.where((halfway_squared_1 > 0.0), along_light_1 * halfway_squared_1 * light_scale_1, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
        specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1


@compiled
def squared_of_2_on_a_row(
    cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
    light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, specular_base_1_row,
    mu_2_row, specular_base_2_row, start, stop
):
    for i in pixels(start, stop):
        cos_theta = cos_theta_row[i]
        sin_theta = sin_theta_row[i]
        cos_phi = cos_phi_row[i]
        sin_phi = sin_phi_row[i]
        h_u = h_u_row[i]
        h_v = h_v_row[i]
        x = x_row[i]
        normal_x = cos_theta * sin_phi
        normal_y = sin_phi * sin_theta
        e_theta_x = -sin_theta
        e_phi_x = cos_phi * cos_theta
        e_phi_y = cos_phi * sin_theta
        e_phi_z = -sin_phi
        g_x = e_phi_x * h_v + e_theta_x * h_u
        g_y = cos_theta * h_u + e_phi_y * h_v
        g_z = e_phi_z * h_v
        m_x = beta * g_x + normal_x
        m_y = beta * g_y + normal_y
        m_z = beta * g_z + cos_phi
        m_length = np.sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
        m_scale = 1.0 / m_length
        bumped_x = m_scale * m_x
        bumped_y = m_scale * m_y
        bumped_z = m_scale * m_z
        point_x = normal_x * radius
        point_y = normal_y * radius
        point_z = cos_phi * radius
        view_scale = 1.0 / np.sqrt(eye * eye + x * x + y * y)
        view_x = -view_scale * x
        view_y = -view_scale * y
        view_z = eye * view_scale
        to_light_x_1 = light_x_1 - point_x
        to_light_y_1 = light_y_1 - point_y
        to_light_z_1 = light_z_1 - point_z
        distance_squared_1 = to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1
        light_distance_1 = np.sqrt(distance_squared_1)
        halfway_x_1 = light_distance_1 * view_x + to_light_x_1
        halfway_y_1 = light_distance_1 * view_y + to_light_y_1
        halfway_z_1 = light_distance_1 * view_z + to_light_z_1
        halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1
        along_light_1 = bumped_x * to_light_x_1 + bumped_y * to_light_y_1 + bumped_z * to_light_z_1
        along_halfway_1 = np.maximum(0.0, bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1)
        light_scale_1 = np.where((halfway_squared_1 > 0.0), 1.0 / (halfway_squared_1 * light_distance_1), 0.0)
        mu_1 = np.where((halfway_squared_1 > 0.0), along_light_1 * halfway_squared_1 * light_scale_1, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
        specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1
        to_light_x_2 = light_x_2 - point_x
        to_light_y_2 = light_y_2 - point_y
        to_light_z_2 = light_z_2 - point_z
        distance_squared_2 = to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2
        light_distance_2 = np.sqrt(distance_squared_2)
        halfway_x_2 = light_distance_2 * view_x + to_light_x_2
        halfway_y_2 = light_distance_2 * view_y + to_light_y_2
        halfway_z_2 = light_distance_2 * view_z + to_light_z_2
        halfway_squared_2 = halfway_x_2 * halfway_x_2 + halfway_y_2 * halfway_y_2 + halfway_z_2 * halfway_z_2
        along_light_2 = bumped_x * to_light_x_2 + bumped_y * to_light_y_2 + bumped_z * to_light_z_2
        along_halfway_2 = np.maximum(0.0, bumped_x * halfway_x_2 + bumped_y * halfway_y_2 + bumped_z * halfway_z_2)
        light_scale_2 = np.where((halfway_squared_2 > 0.0), 1.0 / (halfway_squared_2 * light_distance_2), 0.0)
        mu_2 = np.where((halfway_squared_2 > 0.0), along_light_2 * halfway_squared_2 * light_scale_2, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
        specular_base_2 = along_halfway_2 * along_halfway_2 * light_distance_2 * light_scale_2
        mu_1_row[i] = mu_1
        specular_base_1_row[i] = specular_base_1
        mu_2_row[i] = mu_2
        specular_base_2_row[i] = specular_base_2


@compiled
def light_terms_of_1_on_sphere_row(
    red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green, albedo_blue, kd,
    ks, mu_1_row, specular_1_row, lit_red_1_row, lit_green_1_row, lit_blue_1_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        specular_1 = specular_1_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        shine_1 = ks * specular_1
        lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red
        lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1)
        lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1)
        lit_red_1_row[i] = lit_red_1
        lit_green_1_row[i] = lit_green_1
        lit_blue_1_row[i] = lit_blue_1


@compiled
def light_terms_of_2_on_sphere_row(
    red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green, albedo_blue, kd,
    ks, mu_1_row, specular_1_row, light_red_2, light_green_2, light_blue_2, mu_2_row, specular_2_row,
    lit_red_2_row, lit_green_2_row, lit_blue_2_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        specular_1 = specular_1_row[i]
        mu_2 = mu_2_row[i]
        specular_2 = specular_2_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        shine_1 = ks * specular_1
        lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red
        lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1)
        lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1)
        diffuse_2 = kd * np.maximum(0.0, mu_2)
        shine_2 = ks * specular_2
        lit_red_2 = light_red_2 * (albedo_red * diffuse_2 + shine_2) + lit_red_1
        lit_green_2 = light_green_2 * (albedo_green * diffuse_2 + shine_2) + lit_green_1
        lit_blue_2 = light_blue_2 * (albedo_blue * diffuse_2 + shine_2) + lit_blue_1
        lit_red_2_row[i] = lit_red_2
        lit_green_2_row[i] = lit_green_2
        lit_blue_2_row[i] = lit_blue_2


@compiled
def diffuse_terms_of_1_on_sphere_row(
    mu_1_row, red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green,
    albedo_blue, kd, lit_red_1_row, lit_green_1_row, lit_blue_1_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        lit_red_1 = albedo_red * diffuse_1 * light_red_1 + red
        lit_green_1 = albedo_green * diffuse_1 * light_green_1 + green
        lit_blue_1 = albedo_blue * diffuse_1 * light_blue_1 + blue
        lit_red_1_row[i] = lit_red_1
        lit_green_1_row[i] = lit_green_1
        lit_blue_1_row[i] = lit_blue_1


@compiled
def diffuse_terms_of_2_on_sphere_row(
    mu_1_row, red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green,
    albedo_blue, kd, light_red_2, light_green_2, light_blue_2, mu_2_row, lit_red_2_row, lit_green_2_row,
    lit_blue_2_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        mu_2 = mu_2_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        lit_red_1 = albedo_red * diffuse_1 * light_red_1 + red
        lit_green_1 = albedo_green * diffuse_1 * light_green_1 + green
        lit_blue_1 = albedo_blue * diffuse_1 * light_blue_1 + blue
        diffuse_2 = kd * np.maximum(0.0, mu_2)
        lit_red_2 = albedo_red * diffuse_2 * light_red_2 + lit_red_1
        lit_green_2 = albedo_green * diffuse_2 * light_green_2 + lit_green_1
        lit_blue_2 = albedo_blue * diffuse_2 * light_blue_2 + lit_blue_1
        lit_red_2_row[i] = lit_red_2
        lit_green_2_row[i] = lit_green_2
        lit_blue_2_row[i] = lit_blue_2


@compiled
def light_terms_of_1_on_floor_row(
    red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red_row, albedo_green_row,
    albedo_blue_row, kd, ks, mu_1_row, specular_1_row, lit_red_1_row, lit_green_1_row, lit_blue_1_row, start,
    stop
):
    for i in pixels(start, stop):
        albedo_red = albedo_red_row[i]
        albedo_green = albedo_green_row[i]
        albedo_blue = albedo_blue_row[i]
        mu_1 = mu_1_row[i]
        specular_1 = specular_1_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        shine_1 = ks * specular_1
        lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red
        lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1)
        lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1)
        lit_red_1_row[i] = lit_red_1
        lit_green_1_row[i] = lit_green_1
        lit_blue_1_row[i] = lit_blue_1


@compiled
def light_terms_of_2_on_floor_row(
    red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red_row, albedo_green_row,
    albedo_blue_row, kd, ks, mu_1_row, specular_1_row, light_red_2, light_green_2, light_blue_2, mu_2_row,
    specular_2_row, lit_red_2_row, lit_green_2_row, lit_blue_2_row, start, stop
):
    for i in pixels(start, stop):
        albedo_red = albedo_red_row[i]
        albedo_green = albedo_green_row[i]
        albedo_blue = albedo_blue_row[i]
        mu_1 = mu_1_row[i]
        specular_1 = specular_1_row[i]
        mu_2 = mu_2_row[i]
        specular_2 = specular_2_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        shine_1 = ks * specular_1
        lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red
        lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1)
        lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1)
        diffuse_2 = kd * np.maximum(0.0, mu_2)
        shine_2 = ks * specular_2
        lit_red_2 = light_red_2 * (albedo_red * diffuse_2 + shine_2) + lit_red_1
        lit_green_2 = light_green_2 * (albedo_green * diffuse_2 + shine_2) + lit_green_1
        lit_blue_2 = light_blue_2 * (albedo_blue * diffuse_2 + shine_2) + lit_blue_1
        lit_red_2_row[i] = lit_red_2
        lit_green_2_row[i] = lit_green_2
        lit_blue_2_row[i] = lit_blue_2


@compiled
def diffuse_terms_of_1_on_floor_row(
    mu_1_row, red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red_row, albedo_green_row,
    albedo_blue_row, kd, lit_red_1_row, lit_green_1_row, lit_blue_1_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        albedo_red = albedo_red_row[i]
        albedo_green = albedo_green_row[i]
        albedo_blue = albedo_blue_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        lit_red_1 = albedo_red * diffuse_1 * light_red_1 + red
        lit_green_1 = albedo_green * diffuse_1 * light_green_1 + green
        lit_blue_1 = albedo_blue * diffuse_1 * light_blue_1 + blue
        lit_red_1_row[i] = lit_red_1
        lit_green_1_row[i] = lit_green_1
        lit_blue_1_row[i] = lit_blue_1


@compiled
def diffuse_terms_of_2_on_floor_row(
    mu_1_row, red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red_row, albedo_green_row,
    albedo_blue_row, kd, light_red_2, light_green_2, light_blue_2, mu_2_row, lit_red_2_row, lit_green_2_row,
    lit_blue_2_row, start, stop
):
    for i in pixels(start, stop):
        mu_1 = mu_1_row[i]
        albedo_red = albedo_red_row[i]
        albedo_green = albedo_green_row[i]
        albedo_blue = albedo_blue_row[i]
        mu_2 = mu_2_row[i]
        diffuse_1 = kd * np.maximum(0.0, mu_1)
        lit_red_1 = albedo_red * diffuse_1 * light_red_1 + red
        lit_green_1 = albedo_green * diffuse_1 * light_green_1 + green
        lit_blue_1 = albedo_blue * diffuse_1 * light_blue_1 + blue
        diffuse_2 = kd * np.maximum(0.0, mu_2)
        lit_red_2 = albedo_red * diffuse_2 * light_red_2 + lit_red_1
        lit_green_2 = albedo_green * diffuse_2 * light_green_2 + lit_green_1
        lit_blue_2 = albedo_blue * diffuse_2 * light_blue_2 + lit_blue_1
        lit_red_2_row[i] = lit_red_2
        lit_green_2_row[i] = lit_green_2
        lit_blue_2_row[i] = lit_blue_2


@compiled
def height_sine_row(
    u_row, v_row, k_u, k_v, h_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        h = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v)
        h_row[i] = h


@compiled
def gradient_sine_row(
    u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        cos_u = cospi_of_product(k_u, u)
        cos_v = cospi_of_product(k_v, v)
        sin_u = sinpi_of_product(k_u, u)
        sin_v = sinpi_of_product(k_v, v)
        h_u = np.pi * cos_u * k_u * sin_v
        h_v = np.pi * cos_v * k_v * sin_u
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def kink_sine_row(
    sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop
):
    for i in pixels(start, stop):
        sin_phi = sin_phi_row[i]
        kink = np.where((sin_phi <= 0.0), 1.0, 0.0)
        kink_row[i] = kink


@compiled
def straddling_sine_row(
    u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop
):
    straddles = 0.0
    for i in pixels(start, stop):
        straddles_row[i] = straddles


@compiled
def forward_sine_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        stepped = np.where((epsilon + v <= 1.0), epsilon + v, -epsilon + v)
        h_here = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v)
        h_u_plus = sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v)
        h_v_plus = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, stepped)
        h_u = (-h_here + h_u_plus) / epsilon
        h_v = np.where((epsilon + v <= 1.0), (-h_here + h_v_plus) / epsilon, (h_here - h_v_plus) / epsilon)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central_sine_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        u_minus = -epsilon + u - np.floor(-epsilon + u)
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        h_u_plus = sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v)
        h_u_minus = sinpi_of_product(k_u, u_minus) * sinpi_of_product(k_v, v)
        h_v_plus = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus)
        h_v_minus = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus)
        h_u = 0.5 * (-h_u_minus + h_u_plus) / epsilon
        h_v = (-h_v_minus + h_v_plus) / span_v
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central4_sine_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        u_minus = -epsilon + u - np.floor(-epsilon + u)
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        u_plus_2 = 2.0 * epsilon + u - np.floor(2.0 * epsilon + u)
        u_minus_2 = -2.0 * epsilon + u - np.floor(-2.0 * epsilon + u)
        v_plus_2 = np.minimum(1.0, 2.0 * epsilon + v)
        v_minus_2 = np.maximum(0.0, -2.0 * epsilon + v)
        h_u_plus = sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v)
        h_u_minus = sinpi_of_product(k_u, u_minus) * sinpi_of_product(k_v, v)
        h_v_plus = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus)
        h_v_minus = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus)
        h_u_plus_2 = sinpi_of_product(k_u, u_plus_2) * sinpi_of_product(k_v, v)
        h_u_minus_2 = sinpi_of_product(k_u, u_minus_2) * sinpi_of_product(k_v, v)
        h_v_plus_2 = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus_2)
        h_v_minus_2 = sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus_2)
        near_difference_u = -h_u_minus + h_u_plus
        h_u = (1.0 / 12.0) * (h_u_minus_2 - h_u_plus_2 + 8.0 * near_difference_u) / epsilon
        near_difference_v = -h_v_minus + h_v_plus
        h_v = np.where(((2.0 * epsilon + v <= 1.0) & (2.0 * epsilon - v <= 0.0)), (1.0 / 12.0) * (h_v_minus_2 - h_v_plus_2 + 8.0 * near_difference_v) / epsilon, near_difference_v / span_v)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def gradient_from_factors_sine_row(
    sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        sin_u = sin_u_row[i]
        cos_u = cos_u_row[i]
        sin_v = sin_v_row[i]
        cos_v = cos_v_row[i]
        h_u = np.pi * cos_u * k_u * sin_v
        h_v = np.pi * cos_v * k_v * sin_u
        h_u_row[i] = h_u
        h_v_row[i] = h_v


def wave_numbers_sine(k_u, k_v):
    a = k_u
    b = k_v
    return a, b


@compiled
def height_ridges_row(
    u_row, v_row, k_u, k_v, h_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        h = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v))
        h_row[i] = h


@compiled
def gradient_ridges_row(
    u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        cos_u = cospi_of_product(k_u, u)
        cos_v = cospi_of_product(k_v, v)
        sin_u = sinpi_of_product(k_u, u)
        sin_v = sinpi_of_product(k_v, v)
        h_u = np.pi * cos_u * k_u * sin_v * (np.sign(sin_u) * np.sign(sin_v))
        h_v = np.pi * cos_v * k_v * sin_u * (np.sign(sin_u) * np.sign(sin_v))
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def kink_ridges_row(
    sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop
):
    for i in pixels(start, stop):
        sin_phi = sin_phi_row[i]
        u = u_row[i]
        v = v_row[i]
        kink = np.where(((np.abs(sinpi_of_product(k_u, u)) < (3.0 / 100.0)) | (np.abs(sinpi_of_product(k_v, v)) < (3.0 / 100.0)) | (sin_phi <= 0.0)), 1.0, 0.0)
        kink_row[i] = kink


@compiled
def straddling_ridges_row(
    u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        crease_distance_0 = np.abs(k_u * u - np.rint(k_u * u))
        crease_distance_1 = np.abs(k_v * v - np.rint(k_v * v))
        straddles = np.where(((crease_distance_0 < epsilon * np.abs(k_u)) | (crease_distance_1 < epsilon * np.abs(k_v))), 1.0, 0.0)
        straddles_row[i] = straddles


@compiled
def forward_ridges_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        stepped = np.where((epsilon + v <= 1.0), epsilon + v, -epsilon + v)
        h_here = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v))
        h_u_plus = np.abs(sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v))
        h_v_plus = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, stepped))
        h_u = (-h_here + h_u_plus) / epsilon
        h_v = np.where((epsilon + v <= 1.0), (-h_here + h_v_plus) / epsilon, (h_here - h_v_plus) / epsilon)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central_ridges_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        u_minus = -epsilon + u - np.floor(-epsilon + u)
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        h_u_plus = np.abs(sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v))
        h_u_minus = np.abs(sinpi_of_product(k_u, u_minus) * sinpi_of_product(k_v, v))
        h_v_plus = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus))
        h_v_minus = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus))
        h_u = 0.5 * (-h_u_minus + h_u_plus) / epsilon
        h_v = (-h_v_minus + h_v_plus) / span_v
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central4_ridges_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        u = u_row[i]
        v = v_row[i]
        u_plus = epsilon + u - np.floor(epsilon + u)
        u_minus = -epsilon + u - np.floor(-epsilon + u)
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        u_plus_2 = 2.0 * epsilon + u - np.floor(2.0 * epsilon + u)
        u_minus_2 = -2.0 * epsilon + u - np.floor(-2.0 * epsilon + u)
        v_plus_2 = np.minimum(1.0, 2.0 * epsilon + v)
        v_minus_2 = np.maximum(0.0, -2.0 * epsilon + v)
        h_u_plus = np.abs(sinpi_of_product(k_u, u_plus) * sinpi_of_product(k_v, v))
        h_u_minus = np.abs(sinpi_of_product(k_u, u_minus) * sinpi_of_product(k_v, v))
        h_v_plus = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus))
        h_v_minus = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus))
        h_u_plus_2 = np.abs(sinpi_of_product(k_u, u_plus_2) * sinpi_of_product(k_v, v))
        h_u_minus_2 = np.abs(sinpi_of_product(k_u, u_minus_2) * sinpi_of_product(k_v, v))
        h_v_plus_2 = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_plus_2))
        h_v_minus_2 = np.abs(sinpi_of_product(k_u, u) * sinpi_of_product(k_v, v_minus_2))
        near_difference_u = -h_u_minus + h_u_plus
        h_u = (1.0 / 12.0) * (h_u_minus_2 - h_u_plus_2 + 8.0 * near_difference_u) / epsilon
        near_difference_v = -h_v_minus + h_v_plus
        h_v = np.where(((2.0 * epsilon + v <= 1.0) & (2.0 * epsilon - v <= 0.0)), (1.0 / 12.0) * (h_v_minus_2 - h_v_plus_2 + 8.0 * near_difference_v) / epsilon, near_difference_v / span_v)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def gradient_from_factors_ridges_row(
    sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    for i in pixels(start, stop):
        sin_u = sin_u_row[i]
        cos_u = cos_u_row[i]
        sin_v = sin_v_row[i]
        cos_v = cos_v_row[i]
        h_u = np.pi * cos_u * k_u * sin_v * (np.sign(sin_u) * np.sign(sin_v))
        h_v = np.pi * cos_v * k_v * sin_u * (np.sign(sin_u) * np.sign(sin_v))
        h_u_row[i] = h_u
        h_v_row[i] = h_v


def wave_numbers_ridges(k_u, k_v):
    a = k_u
    b = k_v
    return a, b


@compiled
def height_rings_row(
    u_row, v_row, k_u, k_v, h_row, start, stop
):
    for i in pixels(start, stop):
        v = v_row[i]
        h = sinpi_of_product(2.0 * k_v, v)
        h_row[i] = h


@compiled
def gradient_rings_row(
    u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    h_u = 0.0
    for i in pixels(start, stop):
        v = v_row[i]
        cos_v = cospi_of_product(2.0 * k_v, v)
        h_v = 2.0 * np.pi * cos_v * k_v
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def kink_rings_row(
    sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop
):
    for i in pixels(start, stop):
        sin_phi = sin_phi_row[i]
        kink = np.where((sin_phi <= 0.0), 1.0, 0.0)
        kink_row[i] = kink


@compiled
def straddling_rings_row(
    u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop
):
    straddles = 0.0
    for i in pixels(start, stop):
        straddles_row[i] = straddles


@compiled
def forward_rings_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    h_u = 0.0
    for i in pixels(start, stop):
        v = v_row[i]
        stepped = np.where((epsilon + v <= 1.0), epsilon + v, -epsilon + v)
        h_here = sinpi_of_product(2.0 * k_v, v)
        h_v_plus = sinpi_of_product(2.0 * k_v, stepped)
        h_v = np.where((epsilon + v <= 1.0), (-h_here + h_v_plus) / epsilon, (h_here - h_v_plus) / epsilon)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central_rings_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    h_u = 0.0
    for i in pixels(start, stop):
        v = v_row[i]
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        h_v_plus = sinpi_of_product(2.0 * k_v, v_plus)
        h_v_minus = sinpi_of_product(2.0 * k_v, v_minus)
        h_v = (-h_v_minus + h_v_plus) / span_v
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def central4_rings_row(
    u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop
):
    h_u = 0.0
    for i in pixels(start, stop):
        v = v_row[i]
        v_plus = np.minimum(1.0, epsilon + v)
        v_minus = np.maximum(0.0, -epsilon + v)
        span_v = np.where(((epsilon + v <= 1.0) & (epsilon - v <= 0.0)), 2.0 * epsilon, -v_minus + v_plus)
        v_plus_2 = np.minimum(1.0, 2.0 * epsilon + v)
        v_minus_2 = np.maximum(0.0, -2.0 * epsilon + v)
        h_v_plus = sinpi_of_product(2.0 * k_v, v_plus)
        h_v_minus = sinpi_of_product(2.0 * k_v, v_minus)
        h_v_plus_2 = sinpi_of_product(2.0 * k_v, v_plus_2)
        h_v_minus_2 = sinpi_of_product(2.0 * k_v, v_minus_2)
        near_difference_v = -h_v_minus + h_v_plus
        h_v = np.where(((2.0 * epsilon + v <= 1.0) & (2.0 * epsilon - v <= 0.0)), (1.0 / 12.0) * (h_v_minus_2 - h_v_plus_2 + 8.0 * near_difference_v) / epsilon, near_difference_v / span_v)
        h_u_row[i] = h_u
        h_v_row[i] = h_v


@compiled
def gradient_from_factors_rings_row(
    sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop
):
    h_u = 0.0
    for i in pixels(start, stop):
        cos_v = cos_v_row[i]
        h_v = 2.0 * np.pi * cos_v * k_v
        h_u_row[i] = h_u
        h_v_row[i] = h_v


def wave_numbers_rings(k_u, k_v):
    a = 0.0
    b = 2.0 * k_v
    return a, b


HEIGHT_EVALUATIONS = {'forward': 3, 'central': 4, 'central4': 8}


MAX_ALGEBRAIC = 64


FIELDS = {
    "sine": {
        "height": height_sine_row,
        "gradient": gradient_sine_row,
        "kink": kink_sine_row,
        "straddling": straddling_sine_row,
        "forward": forward_sine_row,
        "central": central_sine_row,
        "central4": central4_sine_row,
        "gradient_from_factors": gradient_from_factors_sine_row,
        "height_evaluations": {'forward': 3, 'central': 4, 'central4': 8},
        "wave_numbers": wave_numbers_sine,
    },
    "ridges": {
        "height": height_ridges_row,
        "gradient": gradient_ridges_row,
        "kink": kink_ridges_row,
        "straddling": straddling_ridges_row,
        "forward": forward_ridges_row,
        "central": central_ridges_row,
        "central4": central4_ridges_row,
        "gradient_from_factors": gradient_from_factors_ridges_row,
        "height_evaluations": {'forward': 3, 'central': 4, 'central4': 8},
        "wave_numbers": wave_numbers_ridges,
    },
    "rings": {
        "height": height_rings_row,
        "gradient": gradient_rings_row,
        "kink": kink_rings_row,
        "straddling": straddling_rings_row,
        "forward": forward_rings_row,
        "central": central_rings_row,
        "central4": central4_rings_row,
        "gradient_from_factors": gradient_from_factors_rings_row,
        "height_evaluations": {'forward': 2, 'central': 2, 'central4': 4},
        "wave_numbers": wave_numbers_rings,
    },
}
