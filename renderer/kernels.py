"""Printed from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.

Each function is one program of the chapter, a line for each line of its derivation. It works on whatever it is given:
NumPy's arrays and float64 numbers (under `numpy.errstate`: a selection computes both of its sides), traced values.
"""

from renderer.operations import (
    Constant,
    binary_exponent,
    elementary,
    floor,
    inf,
    maximum,
    minimum,
    nan,
    pi,
    power_of_two,
    rint,
    sign,
    sqrt,
    sum_of_half_turns,
    where,
)


@elementary
def two_product(a, b):
    product = a * b
    a_split = 134217729.0 * a
    a_excess = a_split - a
    a_high = a_split - a_excess
    a_low = a - a_high
    b_split = 134217729.0 * b
    b_excess = b_split - b
    b_high = b_split - b_excess
    b_low = b - b_high
    error_1 = a_high * b_high - product
    error_2 = a_high * b_low + error_1
    error_3 = a_low * b_high + error_2
    product_error = a_low * b_low + error_3
    return product, product_error


@elementary
def sinpi(product, product_error=0.0):
    quarters = rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    sine = where(quadrant < 0.5, sine_near, where(quadrant < 1.5, cosine_near, where(quadrant < 2.5, -sine_near, -cosine_near)))
    return sine


@elementary
def cospi(product, product_error=0.0):
    quarters = rint(2.0 * product)
    remainder_high = product - 0.5 * quarters
    remainder = product_error + remainder_high
    quadrant = quarters - 4.0 * floor(0.25 * quarters)
    z = remainder * remainder
    sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16
    sine_near = remainder * (sine_tail + 3.141592653589793)
    cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1.0
    cosine = where(quadrant < 0.5, cosine_near, where(quadrant < 1.5, -sine_near, where(quadrant < 2.5, -cosine_near, sine_near)))
    return cosine


@elementary
def atan2pi(ordinate, abscissa):
    larger = maximum(abs(abscissa), abs(ordinate))
    smaller = minimum(abs(abscissa), abs(ordinate))
    middle = where(smaller > 0.3125 * larger, 1.0, 0.0)
    steep = where(smaller > 0.75 * larger, 1.0, 0.0)
    node = where(steep > 0.0, 1.0, where(middle > 0.0, 0.5, 0.0))
    node_value = where(steep > 0.0, 0.25, where(middle > 0.0, 0.14758361765043326, 0.0))
    node_correction = where(steep > 0.0, 0.0, where(middle > 0.0, 1.1095511164473943e-17, 0.0))
    denominator = larger + node * smaller
    ratio = where(larger > 0.0, (smaller - larger * node) / denominator, 0.0)
    ratio_squared = ratio * ratio
    arctangent_tail = ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (0.010976202971854851 - 0.010268060844638409 * ratio_squared) - 0.011789255043844099) + 0.012732395447351627) - 0.013839560268860464) + 0.015157613627799556) - 0.016753151904410034) + 0.018724110951987685) - 0.021220659078919377) + 0.02448537586029159) - 0.028937262380344605) + 0.035367765131532294) - 0.04547284088339867) + 0.06366197723675814) - 0.1061032953945969) - 1.9678676675182486e-17
    small_part = node_correction + ratio * (arctangent_tail + 0.3183098861837907)
    first_octant = node_value + small_part
    first_quadrant = where(abs(abscissa) < abs(ordinate), 0.5 - first_octant, first_octant)
    half_plane = where(abscissa < 0.0, 1.0 - first_quadrant, first_quadrant)
    angle = where(ordinate < 0.0, -half_plane, half_plane)
    return angle


@elementary
def exp(product, product_error=0.0):
    whole = rint(1.4426950408889634 * product)
    away_high = product - 0.693145751953125 * whole
    away_low = 1.4286068203094173e-06 * whole - product_error
    away = away_high - away_low
    away_gained = away_high - away
    away_error = away_gained - away_low
    away_squared = away * away
    exponential_tail = away * (away_squared * (away_squared * (away_squared * (away_squared * (1.6059043836821613e-10 * away_squared + 2.505210838544172e-08) + 2.7557319223985893e-06) + 0.0001984126984126984) + 0.008333333333333333) + 0.16666666666666666) + away_squared * (away_squared * (away_squared * (away_squared * (2.08767569878681e-09 * away_squared + 2.755731922398589e-07) + 2.48015873015873e-05) + 0.001388888888888889) + 0.041666666666666664) + 0.5
    departure_low = away_error + away_squared * exponential_tail
    departure = away + departure_low
    exponential_near = departure + 1.0
    exponential = where(product > 709.0, inf, where(product < -708.0, 0.0, exponential_near * power_of_two(whole)))
    return exponential


@elementary
def log(number):
    scaled_by = where(number < 1.0, 200.0, -200.0)
    scaled = number * power_of_two(scaled_by)
    binary = binary_exponent(1.4142135623730951 * scaled)
    mantissa = scaled * power_of_two(-binary)
    doublings = binary - scaled_by
    node = where(mantissa < 0.890625, 0.79296875, where(mantissa < 1.125, 1.0, 1.26171875))
    node_short = where(mantissa < 0.890625, -0.231964111328125, where(mantissa < 1.125, 0.0, 0.2324676513671875))
    node_rest = where(mantissa < 0.890625, -7.354109650143049e-06, where(mantissa < 1.125, 0.0, 7.227375906564921e-06))
    above_node = mantissa - node
    lifted = mantissa + 134217728.0
    mantissa_short = lifted - 134217728.0
    mantissa_rest = mantissa - mantissa_short
    sum_short = mantissa_short + node
    inverse = 1.0 / (mantissa + node)
    a = above_node * inverse
    a_split = 134217729.0 * a
    a_excess = a_split - a
    a_high = a_split - a_excess
    undivided_near = above_node - a_high * sum_short
    undivided = undivided_near - a_high * mantissa_rest
    quotient_rest = inverse * undivided
    quotient = a_high + quotient_rest
    quotient_squared = quotient * quotient
    log_tail = quotient * quotient_squared * (quotient_squared * (quotient_squared * (quotient_squared * (quotient_squared * (0.15384615384615385 * quotient_squared + 0.18181818181818182) + 0.2222222222222222) + 0.2857142857142857) + 0.4) + 0.6666666666666666)
    log_whole = 0.693145751953125 * doublings + node_short
    log_whole_rest = 1.4286068203094173e-06 * doublings + node_rest
    log_quotient = 2.0 * a_high
    log_rest = log_tail + log_whole_rest + 2.0 * quotient_rest
    log_sum = log_quotient + log_whole
    log_lost = log_whole - log_sum
    log_sum_rest = log_lost + log_quotient
    log_low = log_rest + log_sum_rest
    log_near = log_low + log_sum
    logarithm = where((number <= 1.7976931348623157e+308) & (number > 0.0), log_near, where(number > 1.7976931348623157e+308, inf, where(number == 0.0, -inf, nan)))
    return logarithm


@elementary
def power(number, exponent):
    scaled_by = where(number < 1.0, 200.0, -200.0)
    scaled = number * power_of_two(scaled_by)
    binary = binary_exponent(1.4142135623730951 * scaled)
    mantissa = scaled * power_of_two(-binary)
    doublings = binary - scaled_by
    node = where(mantissa < 0.890625, 0.79296875, where(mantissa < 1.125, 1.0, 1.26171875))
    node_short = where(mantissa < 0.890625, -0.231964111328125, where(mantissa < 1.125, 0.0, 0.2324676513671875))
    node_rest = where(mantissa < 0.890625, -7.354109650143049e-06, where(mantissa < 1.125, 0.0, 7.227375906564921e-06))
    above_node = mantissa - node
    lifted = mantissa + 134217728.0
    mantissa_short = lifted - 134217728.0
    mantissa_rest = mantissa - mantissa_short
    sum_short = mantissa_short + node
    inverse = 1.0 / (mantissa + node)
    a = above_node * inverse
    a_split = 134217729.0 * a
    a_excess = a_split - a
    a_high = a_split - a_excess
    undivided_near = above_node - a_high * sum_short
    undivided = undivided_near - a_high * mantissa_rest
    quotient_rest = inverse * undivided
    quotient = a_high + quotient_rest
    quotient_squared = quotient * quotient
    log_tail = quotient * quotient_squared * (quotient_squared * (quotient_squared * (quotient_squared * (quotient_squared * (0.15384615384615385 * quotient_squared + 0.18181818181818182) + 0.2222222222222222) + 0.2857142857142857) + 0.4) + 0.6666666666666666)
    log_whole = 0.693145751953125 * doublings + node_short
    log_whole_rest = 1.4286068203094173e-06 * doublings + node_rest
    log_quotient = 2.0 * a_high
    log_rest = log_tail + log_whole_rest + 2.0 * quotient_rest
    b = exponent
    b_split = 134217729.0 * b
    b_excess = b_split - b
    b_high = b_split - b_excess
    b_low = b - b_high
    of_whole = b_high * log_whole
    of_quotient = b_high * log_quotient
    product_near = of_quotient + of_whole
    product_lost = of_whole - product_near
    product_near_rest = of_quotient + product_lost
    product_rest = b_low * log_quotient + b_low * log_whole + exponent * log_rest + product_near_rest
    product = product_near + product_rest
    product_gained = product - product_near
    product_error = product_rest - product_gained
    whole = rint(1.4426950408889634 * product)
    away_high = product - 0.693145751953125 * whole
    away_low = 1.4286068203094173e-06 * whole - product_error
    away = away_high - away_low
    away_gained = away_high - away
    away_error = away_gained - away_low
    away_squared = away * away
    exponential_tail = away * (away_squared * (away_squared * (away_squared * (away_squared * (1.6059043836821613e-10 * away_squared + 2.505210838544172e-08) + 2.7557319223985893e-06) + 0.0001984126984126984) + 0.008333333333333333) + 0.16666666666666666) + away_squared * (away_squared * (away_squared * (away_squared * (2.08767569878681e-09 * away_squared + 2.755731922398589e-07) + 2.48015873015873e-05) + 0.001388888888888889) + 0.041666666666666664) + 0.5
    departure_low = away_error + away_squared * exponential_tail
    departure = away + departure_low
    exponential_near = departure + 1.0
    exponential = where(product > 709.0, inf, where(product < -708.0, 0.0, exponential_near * power_of_two(whole)))
    power = where(number <= 0.0, 0.0, exponential)
    return power


def image_extent(eye, radius):
    tangent_squared = (eye - radius) * (eye + radius)
    half = 1.25 * eye * radius / sqrt(tangent_squared)
    return half


def image_x(column, width, height, half):
    return half * (2.0 * column - width + 1.0) / height


def image_y(row, height, half):
    return half * (Constant(-0.15) + (height - 2.0 * row - 1.0) / height)


def silhouette_of_a(eye, radius):
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / sqrt(tangent_squared)
    return rho_silhouette


def tangent_interval(apex, apex_height, center, center_height, sphere_radius, level):
    across = center - apex
    drop = apex_height - center_height
    spread = sphere_radius * sqrt(across * across + (drop - sphere_radius) * (drop + sphere_radius))
    slope_low = (across * drop - spread) / ((drop - sphere_radius) * (drop + sphere_radius))
    slope_high = (across * drop + spread) / ((drop - sphere_radius) * (drop + sphere_radius))
    low = apex + slope_low * (apex_height - level)
    high = apex + slope_high * (apex_height - level)
    return low, high


def shadow_clearance(light_x, light_y, light_z, center_x, center_y, center_z, body_radius, ball_center_x, ball_center_y, ball_center_z, ball_radius):
    from_body_x = light_x - center_x
    from_body_y = light_y - center_y
    from_body_z = light_z - center_z
    along_x = ball_center_x - light_x
    along_y = ball_center_y - light_y
    along_z = ball_center_z - light_z
    at_light = from_body_x * from_body_x - body_radius * body_radius + from_body_y * from_body_y + from_body_z * from_body_z
    half_slope = along_x * from_body_x + along_y * from_body_y + along_z * from_body_z - ball_radius * body_radius
    curvature = along_x * along_x + along_y * along_y + along_z * along_z - ball_radius * ball_radius
    turning = where(half_slope >= 0.0, 0.0, where(curvature + half_slope <= 0.0, 1.0, -half_slope / curvature))
    at_ball = at_light + curvature + 2.0 * half_slope
    at_turning = at_light + turning * (curvature * turning + 2.0 * half_slope)
    at_an_end = where(at_ball < at_light, at_ball, at_light)
    shortest = where(at_an_end > at_turning, at_turning, at_an_end)
    clearance = shortest / (along_x * along_x + along_y * along_y + along_z * along_z + from_body_x * from_body_x + from_body_y * from_body_y + from_body_z * from_body_z)
    return clearance


def ambient_term(ka, ambient):
    return ambient * ka


def floor_albedo(floor_dark, floor_tint):
    floor_base = where(floor_dark > 0.0, Constant(0.15), Constant(0.85))
    floor_red = floor_base * (1.0 - floor_tint)
    floor_blue = floor_base
    return floor_red, floor_blue


def visible_surface(x, y, eye, radius, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, floor_on):
    rho_raw = sqrt(x * x + y * y)
    rho = where(rho_raw >= Constant(1e-150) * eye, rho_raw, 0.0)
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / sqrt(tangent_squared)
    discriminant_a = tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette)
    root_a = sqrt(maximum(0.0, discriminant_a))
    t_a = where(discriminant_a >= 0.0, tangent_squared / (eye * eye + root_a), inf)
    distance = eye - ball_center_z
    toward_b = ball_center_x * x + ball_center_y * y + distance * eye
    discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (distance * y - ball_center_y * eye) * (distance * y - ball_center_y * eye)
    root_b = sqrt(maximum(0.0, discriminant_b))
    t_b = where((ball_on > 0.0) & (discriminant_b >= 0.0) & (toward_b > 0.0), (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (distance - ball_radius) * (ball_radius + distance)) / (root_b + toward_b), inf)
    t_floor = where(floor_on > 0.0, 1.0, inf)
    surface = where((t_a < inf) & (t_a <= t_b) & (t_a <= t_floor), 1.0, where((t_b < inf) & (t_b <= t_floor), 2.0, where(t_floor < inf, 3.0, 0.0)))
    return surface


def angles_on_a(x, y, eye, radius):
    rho_raw = sqrt(x * x + y * y)
    rho = where(rho_raw >= Constant(1e-150) * eye, rho_raw, 0.0)
    tangent_squared = (eye - radius) * (eye + radius)
    rho_silhouette = eye * radius / sqrt(tangent_squared)
    discriminant_a = tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette)
    root_a = sqrt(maximum(0.0, discriminant_a))
    rho_inverse = where(rho > 0.0, 1.0 / rho, 0.0)
    hit_scale = 1.0 / (radius * (eye * eye + root_a))
    cos_theta = rho_inverse * x
    sin_theta = rho_inverse * y
    sin_phi = hit_scale * rho * tangent_squared
    cos_phi = eye * hit_scale * (radius * radius + root_a)
    return cos_theta, sin_theta, cos_phi, sin_phi


def point_on_a(cos_theta, sin_theta, cos_phi, sin_phi, radius):
    return cos_theta * radius * sin_phi, radius * sin_phi * sin_theta, cos_phi * radius


def normal_of_b(x, y, eye, ball_center_x, ball_center_y, ball_center_z, ball_radius):
    distance = eye - ball_center_z
    discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (distance * y - ball_center_y * eye) * (distance * y - ball_center_y * eye)
    root_b = sqrt(maximum(0.0, discriminant_b))
    moment_x = distance * y - ball_center_y * eye
    moment_y = ball_center_x * eye - distance * x
    moment_z = ball_center_x * y - ball_center_y * x
    ray_length_squared = eye * eye + x * x + y * y
    radius_vector_x = (-eye * moment_y - moment_z * y - root_b * x) / ray_length_squared
    radius_vector_y = (eye * moment_x + moment_z * x - root_b * y) / ray_length_squared
    radius_vector_z = (eye * root_b + moment_x * y - moment_y * x) / ray_length_squared
    radius_length = sqrt(radius_vector_x * radius_vector_x + radius_vector_y * radius_vector_y + radius_vector_z * radius_vector_z)
    normal_x = radius_vector_x / radius_length
    normal_y = radius_vector_y / radius_length
    normal_z = radius_vector_z / radius_length
    point_x = ball_center_x + ball_radius * normal_x
    point_y = ball_center_y + ball_radius * normal_y
    point_z = ball_center_z + ball_radius * normal_z
    return point_x, point_y, point_z, normal_x, normal_y, normal_z


def normal_of_floor(x, y):
    return x, y, 0.0, 0.0, 0.0, 1.0


def view_length(x, y, eye):
    return 1.0 / sqrt(eye * eye + x * x + y * y)


def view_direction(x, y, eye, view_scale):
    return -view_scale * x, -view_scale * y, eye * view_scale


def shadow(point_x, point_y, point_z, light_x, light_y, light_z, center_x, center_y, center_z, body_radius):
    segment_x = light_x - point_x
    segment_y = light_y - point_y
    segment_z = light_z - point_z
    offset_x = center_x - point_x
    offset_y = center_y - point_y
    offset_z = center_z - point_z
    segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z
    toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z
    shadow_discriminant = body_radius * body_radius * segment_squared - (offset_y * segment_x - offset_x * segment_y) * (offset_y * segment_x - offset_x * segment_y) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (offset_z * segment_y - offset_y * segment_z) * (offset_z * segment_y - offset_y * segment_z)
    occluded = where((segment_squared > toward_center) & (shadow_discriminant >= 0.0) & (toward_center > 0.0), 1.0, 0.0)
    return occluded


def checker(point_x, point_y):
    square = floor(point_x) + floor(point_y)
    dark = where((point_x != floor(point_x)) & (point_y != floor(point_y)) & (square != 2.0 * floor(0.5 * square)), 1.0, 0.0)
    return dark


def chart(cos_theta, sin_theta, cos_phi, sin_phi):
    u_closed = 0.5 * atan2pi(sin_theta, cos_theta) + 0.5
    u = where(u_closed < 1.0, u_closed, 0.0)
    v = atan2pi(sin_phi, cos_phi)
    return u, v


def chart_radians(u, v):
    return pi * (2.0 * u - 1.0), pi * v


def algebraic_bases(cos_theta, sin_theta, cos_phi, sin_phi):
    return -cos_theta, -sin_theta, cos_phi, sin_phi


def complex_square(real_part, imaginary_part):
    return (real_part - imaginary_part) * (imaginary_part + real_part), 2.0 * imaginary_part * real_part


def complex_product(real_part, imaginary_part, other_real, other_imaginary):
    product_real = other_real * real_part - imaginary_part * other_imaginary
    product_imaginary = imaginary_part * other_real + other_imaginary * real_part
    return product_real, product_imaginary


def slope(h_u, h_v):
    return sqrt(h_u * h_u + h_v * h_v)


def bumped_normal(cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta):
    normal_x = cos_theta * sin_phi
    normal_y = sin_phi * sin_theta
    normal_z = cos_phi
    e_theta_x = -sin_theta
    e_theta_y = cos_theta
    e_theta_z = 0.0
    e_phi_x = cos_phi * cos_theta
    e_phi_y = cos_phi * sin_theta
    e_phi_z = -sin_phi
    g_x = e_phi_x * h_v + e_theta_x * h_u
    g_y = e_phi_y * h_v + e_theta_y * h_u
    g_z = e_phi_z * h_v + e_theta_z * h_u
    m_x = beta * g_x + normal_x
    m_y = beta * g_y + normal_y
    m_z = beta * g_z + normal_z
    m_length = sqrt(m_x * m_x + m_y * m_y + m_z * m_z)
    m_scale = 1.0 / m_length
    bumped_x = m_scale * m_x
    bumped_y = m_scale * m_y
    bumped_z = m_scale * m_z
    return bumped_x, bumped_y, bumped_z


def surface_slopes(sin_phi, radius, h_u, h_v):
    arc = -pi * radius
    slope_theta = where(sin_phi > 0.0, 0.5 * h_u / (arc * sin_phi), 0.0)
    slope_phi = where(sin_phi > 0.0, h_v / arc, 0.0)
    return slope_theta, slope_phi


def light_cosine(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    light_distance = sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
    light_scale = 1.0 / light_distance
    towards_x = light_scale * to_light_x
    towards_y = light_scale * to_light_y
    towards_z = light_scale * to_light_z
    mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
    return mu


def height_of_light(point_x, point_y, point_z, light_x, light_y, light_z, normal_x, normal_y, normal_z):
    above = normal_x * (light_x - point_x) + normal_y * (light_y - point_y) + normal_z * (light_z - point_z)
    return above


def blinn(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z, view_x, view_y, view_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    light_distance = sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
    light_scale = 1.0 / light_distance
    towards_x = light_scale * to_light_x
    towards_y = light_scale * to_light_y
    towards_z = light_scale * to_light_z
    mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
    halfway_x = towards_x + view_x
    halfway_y = towards_y + view_y
    halfway_z = towards_z + view_z
    halfway_length = sqrt(halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z)
    specular_base = where(halfway_length > 0.0, maximum(0.0, (bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z) / halfway_length), 0.0)
    return mu, specular_base


def blinn_squared(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z, view_x, view_y, view_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    distance_squared = to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z
    light_distance = sqrt(distance_squared)
    halfway_x = light_distance * view_x + to_light_x
    halfway_y = light_distance * view_y + to_light_y
    halfway_z = light_distance * view_z + to_light_z
    halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z
    along_light = bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z
    along_halfway = maximum(0.0, bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z)
    light_scale = where(halfway_squared > 0.0, 1.0 / (halfway_squared * light_distance), 0.0)
    mu = where(halfway_squared > 0.0, along_light * halfway_squared * light_scale, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
    specular_base = along_halfway * along_halfway * light_distance * light_scale
    return mu, specular_base


def phong(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z, view_x, view_y, view_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    light_distance = sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
    light_scale = 1.0 / light_distance
    towards_x = light_scale * to_light_x
    towards_y = light_scale * to_light_y
    towards_z = light_scale * to_light_z
    mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
    specular_base = maximum(0.0, 2.0 * mu * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x * view_x - towards_y * view_y - towards_z * view_z)
    return mu, specular_base


def blinn_gated(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z, view_x, view_y, view_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    light_distance = sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z)
    light_scale = 1.0 / light_distance
    towards_x = light_scale * to_light_x
    towards_y = light_scale * to_light_y
    towards_z = light_scale * to_light_z
    mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z
    halfway_x = towards_x + view_x
    halfway_y = towards_y + view_y
    halfway_z = towards_z + view_z
    halfway_length = sqrt(halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z)
    ungated = where(halfway_length > 0.0, maximum(0.0, (bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z) / halfway_length), 0.0)
    specular_base = where(mu > 0.0, ungated, 0.0)
    return mu, specular_base


def blinn_gated_squared(point_x, point_y, point_z, light_x, light_y, light_z, bumped_x, bumped_y, bumped_z, view_x, view_y, view_z):
    to_light_x = light_x - point_x
    to_light_y = light_y - point_y
    to_light_z = light_z - point_z
    distance_squared = to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z
    light_distance = sqrt(distance_squared)
    halfway_x = light_distance * view_x + to_light_x
    halfway_y = light_distance * view_y + to_light_y
    halfway_z = light_distance * view_z + to_light_z
    halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z
    along_light = bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z
    along_halfway = maximum(0.0, bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z)
    light_scale = where(halfway_squared > 0.0, 1.0 / (halfway_squared * light_distance), 0.0)
    mu = where(halfway_squared > 0.0, along_light * halfway_squared * light_scale, -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z)
    ungated = along_halfway * along_halfway * light_distance * light_scale
    specular_base = where(mu > 0.0, ungated, 0.0)
    return mu, specular_base


def highlight(specular_base, shininess):
    return power(specular_base, shininess)


def light_term(red, green, blue, light_red, light_green, light_blue, albedo_red, albedo_green, albedo_blue, kd, ks, mu, specular):
    diffuse = kd * maximum(0.0, mu)
    shine = ks * specular
    lit_red = light_red * (albedo_red * diffuse + shine) + red
    lit_green = green + light_green * (albedo_green * diffuse + shine)
    lit_blue = blue + light_blue * (albedo_blue * diffuse + shine)
    return lit_red, lit_green, lit_blue


def clip(color):
    return minimum(1.0, maximum(0.0, color))


def height_sine(u, v, k_u, k_v):
    return sinpi(*two_product(k_u, u)) * sinpi(*two_product(k_v, v))


def gradient_sine(u, v, k_u, k_v):
    cos_u = cospi(*two_product(k_u, u))
    cos_v = cospi(*two_product(k_v, v))
    sin_u = sinpi(*two_product(k_u, u))
    sin_v = sinpi(*two_product(k_v, v))
    h_u = pi * cos_u * k_u * sin_v
    h_v = pi * cos_v * k_v * sin_u
    return h_u, h_v


def kink_sine(sin_phi, u, v, k_u, k_v):
    return where(sin_phi <= 0.0, 1.0, 0.0)


def straddling_sine(u, v, k_u, k_v, eps):
    return 0.0


def gradient_from_factors_sine(sin_u, cos_u, sin_v, cos_v, k_u, k_v):
    return pi * cos_u * k_u * sin_v, pi * cos_v * k_v * sin_u


def wave_numbers_sine(k_u, k_v):
    return k_u, k_v


def height_ridges(u, v, k_u, k_v):
    return abs(sinpi(*two_product(k_u, u)) * sinpi(*two_product(k_v, v)))


def gradient_ridges(u, v, k_u, k_v):
    cos_u = cospi(*two_product(k_u, u))
    cos_v = cospi(*two_product(k_v, v))
    sin_u = sinpi(*two_product(k_u, u))
    sin_v = sinpi(*two_product(k_v, v))
    h_u = pi * cos_u * k_u * sin_v * (sign(sin_u) * sign(sin_v))
    h_v = pi * cos_v * k_v * sin_u * (sign(sin_u) * sign(sin_v))
    return h_u, h_v


def kink_ridges(sin_phi, u, v, k_u, k_v):
    kink = where((abs(sinpi(*two_product(k_u, u))) < Constant(0.03)) | (abs(sinpi(*two_product(k_v, v))) < Constant(0.03)) | (sin_phi <= 0.0), 1.0, 0.0)
    return kink


def straddling_ridges(u, v, k_u, k_v, eps):
    crease_distance_0 = abs(k_u * u - rint(k_u * u))
    crease_distance_1 = abs(abs(k_v * v) - maximum(1.0, rint(abs(k_v * v))))
    straddles = where((crease_distance_0 < eps * abs(k_u)) | (crease_distance_1 < eps * abs(k_v)), 1.0, 0.0)
    return straddles


def gradient_from_factors_ridges(sin_u, cos_u, sin_v, cos_v, k_u, k_v):
    h_u = pi * cos_u * k_u * sin_v * (sign(sin_u) * sign(sin_v))
    h_v = pi * cos_v * k_v * sin_u * (sign(sin_u) * sign(sin_v))
    return h_u, h_v


def wave_numbers_ridges(k_u, k_v):
    return k_u, k_v


def height_rings(u, v, k_u, k_v):
    return sinpi(*two_product(2.0 * k_v, v))


def gradient_rings(u, v, k_u, k_v):
    cos_v = cospi(*two_product(2.0 * k_v, v))
    h_u = 0.0
    h_v = 2.0 * pi * cos_v * k_v
    return h_u, h_v


def kink_rings(sin_phi, u, v, k_u, k_v):
    return where(sin_phi <= 0.0, 1.0, 0.0)


def straddling_rings(u, v, k_u, k_v, eps):
    return 0.0


def gradient_from_factors_rings(sin_u, cos_u, sin_v, cos_v, k_u, k_v):
    return 0.0, 2.0 * pi * cos_v * k_v


def wave_numbers_rings(k_u, k_v):
    return 0.0, 2.0 * k_v


def forward(height, u, v, k_u, k_v, eps):
    u_plus = eps + u - floor(eps + u)
    stepped = where(eps + v <= 1.0, eps + v, v - eps)
    h_here = height(u, v, k_u, k_v)
    h_u_plus = height(u_plus, v, k_u, k_v)
    h_v_plus = height(u, stepped, k_u, k_v)
    h_u = (h_u_plus - h_here) / eps
    h_v = where(eps + v <= 1.0, (h_v_plus - h_here) / eps, (h_here - h_v_plus) / eps)
    return h_u, h_v


def forward_in_v(height, u, v, k_u, k_v, eps):
    stepped = where(eps + v <= 1.0, eps + v, v - eps)
    h_here = height(u, v, k_u, k_v)
    h_v_plus = height(u, stepped, k_u, k_v)
    h_v = where(eps + v <= 1.0, (h_v_plus - h_here) / eps, (h_here - h_v_plus) / eps)
    return h_v


def central(height, u, v, k_u, k_v, eps):
    u_plus = eps + u - floor(eps + u)
    u_minus = u - eps - floor(u - eps)
    v_plus = minimum(1.0, eps + v)
    v_minus = maximum(0.0, v - eps)
    span_v = where((eps + v <= 1.0) & (eps - v <= 0.0), 2.0 * eps, v_plus - v_minus)
    h_u_plus = height(u_plus, v, k_u, k_v)
    h_u_minus = height(u_minus, v, k_u, k_v)
    h_v_plus = height(u, v_plus, k_u, k_v)
    h_v_minus = height(u, v_minus, k_u, k_v)
    h_u = 0.5 * (h_u_plus - h_u_minus) / eps
    h_v = (h_v_plus - h_v_minus) / span_v
    return h_u, h_v


def central_in_v(height, u, v, k_u, k_v, eps):
    v_plus = minimum(1.0, eps + v)
    v_minus = maximum(0.0, v - eps)
    span_v = where((eps + v <= 1.0) & (eps - v <= 0.0), 2.0 * eps, v_plus - v_minus)
    h_v_plus = height(u, v_plus, k_u, k_v)
    h_v_minus = height(u, v_minus, k_u, k_v)
    h_v = (h_v_plus - h_v_minus) / span_v
    return h_v


def central4(height, u, v, k_u, k_v, eps):
    u_plus = eps + u - floor(eps + u)
    u_minus = u - eps - floor(u - eps)
    v_plus = minimum(1.0, eps + v)
    v_minus = maximum(0.0, v - eps)
    span_v = where((eps + v <= 1.0) & (eps - v <= 0.0), 2.0 * eps, v_plus - v_minus)
    u_plus_2 = 2.0 * eps + u - floor(2.0 * eps + u)
    u_minus_2 = u - 2.0 * eps - floor(u - 2.0 * eps)
    v_plus_2 = minimum(1.0, 2.0 * eps + v)
    v_minus_2 = maximum(0.0, v - 2.0 * eps)
    h_u_plus = height(u_plus, v, k_u, k_v)
    h_u_minus = height(u_minus, v, k_u, k_v)
    h_v_plus = height(u, v_plus, k_u, k_v)
    h_v_minus = height(u, v_minus, k_u, k_v)
    h_u_plus_2 = height(u_plus_2, v, k_u, k_v)
    h_u_minus_2 = height(u_minus_2, v, k_u, k_v)
    h_v_plus_2 = height(u, v_plus_2, k_u, k_v)
    h_v_minus_2 = height(u, v_minus_2, k_u, k_v)
    near_difference_u = h_u_plus - h_u_minus
    h_u = Constant(0.08333333333333333) * (h_u_minus_2 - h_u_plus_2 + 8.0 * near_difference_u) / eps
    near_difference_v = h_v_plus - h_v_minus
    h_v = where((2.0 * eps + v <= 1.0) & (2.0 * eps - v <= 0.0), Constant(0.08333333333333333) * (h_v_minus_2 - h_v_plus_2 + 8.0 * near_difference_v) / eps, near_difference_v / span_v)
    return h_u, h_v


def central4_in_v(height, u, v, k_u, k_v, eps):
    v_plus = minimum(1.0, eps + v)
    v_minus = maximum(0.0, v - eps)
    span_v = where((eps + v <= 1.0) & (eps - v <= 0.0), 2.0 * eps, v_plus - v_minus)
    v_plus_2 = minimum(1.0, 2.0 * eps + v)
    v_minus_2 = maximum(0.0, v - 2.0 * eps)
    h_v_plus = height(u, v_plus, k_u, k_v)
    h_v_minus = height(u, v_minus, k_u, k_v)
    h_v_plus_2 = height(u, v_plus_2, k_u, k_v)
    h_v_minus_2 = height(u, v_minus_2, k_u, k_v)
    near_difference_v = h_v_plus - h_v_minus
    h_v = where((2.0 * eps + v <= 1.0) & (2.0 * eps - v <= 0.0), Constant(0.08333333333333333) * (h_v_minus_2 - h_v_plus_2 + 8.0 * near_difference_v) / eps, near_difference_v / span_v)
    return h_v


ROUNDINGS = {"sinpi": 5.04, "cospi": 5.04, "atan2pi": 5.0, "exp": 2.0, "log": 1.04, "power": 3.0, "small_power": 22.06}
SMALL_POWER = 2.117582368135751e-22


HEIGHT_EVALUATIONS = {"forward": 3, "central": 4, "central4": 8}
MAX_ALGEBRAIC = 64


FIELDS = {
    "sine": {
        "height": height_sine,
        "gradient": gradient_sine,
        "kink": kink_sine,
        "straddling": straddling_sine,
        "gradient_from_factors": gradient_from_factors_sine,
        "wave_numbers": wave_numbers_sine,
        "level_without": ("k_u", "k_v"),
        "forward": forward, "central": central, "central4": central4,
        "height_evaluations": {"forward": 3, "central": 4, "central4": 8},
    },
    "ridges": {
        "height": height_ridges,
        "gradient": gradient_ridges,
        "kink": kink_ridges,
        "straddling": straddling_ridges,
        "gradient_from_factors": gradient_from_factors_ridges,
        "wave_numbers": wave_numbers_ridges,
        "level_without": ("k_u", "k_v"),
        "forward": forward, "central": central, "central4": central4,
        "height_evaluations": {"forward": 3, "central": 4, "central4": 8},
    },
    "rings": {
        "height": height_rings,
        "gradient": gradient_rings,
        "kink": kink_rings,
        "straddling": straddling_rings,
        "gradient_from_factors": gradient_from_factors_rings,
        "wave_numbers": wave_numbers_rings,
        "level_without": ("k_v",),
        "forward": forward_in_v, "central": central_in_v, "central4": central4_in_v,
        "height_evaluations": {"forward": 2, "central": 2, "central4": 4},
    },
}


LIGHT_MODELS = {
    "blinn": (blinn, blinn_squared),
    "phong": (phong, None),
    "blinn_gated": (blinn_gated, blinn_gated_squared),
}
"""{name: (its kernel, that of the squared base)}"""
