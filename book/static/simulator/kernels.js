// Generated from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.
//
// Each `*_row` function runs over the pixels start <= i < stop of a row: arguments ending in `_row` are Float64Arrays,
// the others are numbers, and results are written to the last arrays. Bit for bit the kernels of renderer/kernels.py.
// One function stands around them all, so that a worker can be made from its text.
"use strict";
var Simulator = Simulator || {};

Simulator.kernels = function () {

let spare = [];

function spare_rows(count, length) {
  if (spare.length < count || spare[0].length < length) {
    spare = Array.from({ length: Math.max(count, spare.length) }, () => new Float64Array(length));
  }
  return spare;
}

function maximum(a, b) {
  return b > a ? b : a;
}

function minimum(a, b) {
  return b < a ? b : a;
}

function sign(a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}

// To the nearest whole number, ties to even, the sign of zero kept: adding 2^52 leaves no bits for a fraction.
function rint(a) {
  const size = Math.abs(a), rounded = size + 4503599627370496 - 4503599627370496;
  return size > 0 && size < 4503599627370496 ? (a < 0 ? -rounded : rounded) : a;
}

function image_extent(eye, radius) {
  const tangent_squared = (eye - radius) * (eye + radius),
    half = 1.25 * eye * radius / Math.sqrt(tangent_squared);
  return half;
}

function image_x(column, width, height, half) {
  const x = half * (2 * column - width + 1) / height;
  return x;
}

function image_y(row, height, half) {
  const y = half * ((-3 / 20) + (height - 2 * row - 1) / height);
  return y;
}

function ambient_term(ka, ambient) {
  const color = ambient * ka;
  return color;
}

function floor_albedo(floor_dark, floor_tint) {
  const floor_base = ((floor_dark > 0) ? (3 / 20) : (17 / 20)),
    floor_red = floor_base * (1 - floor_tint),
    floor_blue = floor_base;
  return [floor_red, floor_blue];
}

function parallel_radius(sin_phi, cos_phi, eye, radius) {
  const rho = eye * radius * sin_phi / (-cos_phi * radius + eye);
  return rho;
}

function truncation_bound(epsilon, frequency) {
  const truncation = (1 / 6) * Math.PI * Math.PI * Math.PI * epsilon * epsilon * frequency * frequency * frequency;
  return truncation;
}

function clamped_bound(epsilon, v, frequency) {
  const truncation = Math.PI * Math.PI * Math.PI * frequency * frequency * frequency * ((1 / 6) * epsilon * epsilon + (1 / 3) * epsilon * v - (1 / 3) * v * v);
  return truncation;
}

function rounding_bound(epsilon, steepest, unit, evaluation, argument) {
  const rounding = steepest * (unit * unit + 2 * unit) + (unit + 1) * (unit + 1) * (argument * steepest + evaluation) / epsilon;
  return rounding;
}

function crease_bound(frequency) {
  const apart = 2 * Math.PI * frequency;
  return apart;
}

function slope_bound(frequency) {
  const steepest = Math.PI * frequency;
  return steepest;
}

function sinpi_of_product_row(a, b_row, sine_row, start, stop) {
  const a_split = 134217729 * a,
    a_excess = -a + a_split,
    a_high = -a_excess + a_split,
    a_low = a - a_high;
  for (let i = start; i < stop; i++) {
    const b = b_row[i];
    const product = a * b,
      b_split = 134217729 * b,
      b_excess = -b + b_split,
      b_high = -b_excess + b_split,
      b_low = b - b_high,
      error_1 = a_high * b_high - product,
      error_2 = a_high * b_low + error_1,
      error_3 = a_low * b_high + error_2,
      product_error = a_low * b_low + error_3,
      quarters = rint(2 * product),
      remainder_high = product - 0.5 * quarters,
      remainder = product_error + remainder_high,
      quadrant = quarters - 4 * Math.floor(0.25 * quarters),
      z = remainder * remainder,
      sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16,
      sine_near = remainder * (sine_tail + 3.141592653589793),
      cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1,
      sine = ((quadrant < 0.5) ? sine_near : ((quadrant < 1.5) ? cosine_near : ((quadrant < 2.5) ? -sine_near : -cosine_near)));
    sine_row[i] = sine;
  }
}

function cospi_of_product_row(a, b_row, cosine_row, start, stop) {
  const a_split = 134217729 * a,
    a_excess = -a + a_split,
    a_high = -a_excess + a_split,
    a_low = a - a_high;
  for (let i = start; i < stop; i++) {
    const b = b_row[i];
    const product = a * b,
      b_split = 134217729 * b,
      b_excess = -b + b_split,
      b_high = -b_excess + b_split,
      b_low = b - b_high,
      error_1 = a_high * b_high - product,
      error_2 = a_high * b_low + error_1,
      error_3 = a_low * b_high + error_2,
      product_error = a_low * b_low + error_3,
      quarters = rint(2 * product),
      remainder_high = product - 0.5 * quarters,
      remainder = product_error + remainder_high,
      quadrant = quarters - 4 * Math.floor(0.25 * quarters),
      z = remainder * remainder,
      sine_tail = z * (z * (z * (z * (z * (z * (z * (7.952054001475513e-07 * z - 2.1915353447830217e-05) + 0.00046630280576761255) - 0.0073704309457143504) + 0.08214588661112823) - 0.5992645293207921) + 2.5501640398773455) - 5.16771278004997) + 1.2246467991473532e-16,
      sine_near = remainder * (sine_tail + 3.141592653589793),
      cosine_near = z * (z * (z * (z * (z * (z * (z * (4.303069587032947e-06 * z - 0.0001046381049248457) + 0.0019295743094039231) - 0.02580689139001406) + 0.2353306303588932) - 1.3352627688545895) + 4.0587121264167685) - 4.934802200544679) + 1,
      cosine = ((quadrant < 0.5) ? cosine_near : ((quadrant < 1.5) ? -sine_near : ((quadrant < 2.5) ? -cosine_near : sine_near)));
    cosine_row[i] = cosine;
  }
}

function atan2pi_row(ordinate_row, abscissa_row, angle_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const abscissa = abscissa_row[i],
      ordinate = ordinate_row[i];
    const larger = maximum(Math.abs(abscissa), Math.abs(ordinate)),
      smaller = minimum(Math.abs(abscissa), Math.abs(ordinate)),
      middle = ((smaller > 0.3125 * larger) ? 1 : 0),
      steep = ((smaller > 0.75 * larger) ? 1 : 0),
      node = ((steep > 0) ? 1 : ((middle > 0) ? 0.5 : 0)),
      node_value = ((steep > 0) ? 0.25 : ((middle > 0) ? 0.14758361765043326 : 0)),
      node_correction = ((steep > 0) ? 0 : ((middle > 0) ? 1.1095511164473943e-17 : 0)),
      denominator = larger + node * smaller,
      ratio = ((larger > 0) ? (-larger * node + smaller) / denominator : 0),
      ratio_squared = ratio * ratio,
      arctangent_tail = ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (0.010976202971854851 - 0.010268060844638409 * ratio_squared) - 0.011789255043844099) + 0.012732395447351627) - 0.013839560268860464) + 0.015157613627799556) - 0.016753151904410034) + 0.018724110951987685) - 0.021220659078919377) + 0.02448537586029159) - 0.028937262380344605) + 0.035367765131532294) - 0.04547284088339867) + 0.06366197723675814) - 0.10610329539459688) - 1.9678676675182486e-17,
      small_part = node_correction + ratio * (arctangent_tail + 0.3183098861837907),
      first_octant = node_value + small_part,
      first_quadrant = ((Math.abs(abscissa) < Math.abs(ordinate)) ? 0.5 - first_octant : first_octant),
      half_plane = ((abscissa < 0) ? 1 - first_quadrant : first_quadrant),
      angle = ((ordinate < 0) ? -half_plane : half_plane);
    angle_row[i] = angle;
  }
}

function visible_surface_row(
x_row, y, eye, radius, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, floor_on, surface_row,
start, stop
) {
  const tangent_squared = (eye - radius) * (eye + radius),
    rho_silhouette = eye * radius / Math.sqrt(tangent_squared),
    distance = -ball_center_z + eye,
    t_floor = ((floor_on > 0) ? 1 : Infinity);
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const rho_raw = Math.sqrt(x * x + y * y),
      rho = ((rho_raw >= (1 / 1e+150) * eye) ? rho_raw : 0),
      discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette),
      root_a = Math.sqrt(maximum(0, discriminant_a)),
      t_a = ((discriminant_a >= 0) ? tangent_squared / (eye * eye + root_a) : Infinity),
      toward_b = ball_center_x * x + ball_center_y * y + distance * eye,
      discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y),
      root_b = Math.sqrt(maximum(0, discriminant_b)),
      t_b = (((ball_on > 0) & (discriminant_b >= 0) & (toward_b > 0)) ? (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b) : Infinity),
      surface = (((t_a < Infinity) & (t_a <= t_b) & (t_a <= t_floor)) ? 1 : (((t_b < Infinity) & (t_b <= t_floor)) ? 2 : ((t_floor < Infinity) ? 3 : 0)));
    surface_row[i] = surface;
  }
}

function shadow_on_a_row(
x_row, y, eye, radius, light_x, light_y, light_z, center_x, center_y, center_z, body_radius, occluded_row,
start, stop
) {
  const tangent_squared = (eye - radius) * (eye + radius),
    rho_silhouette = eye * radius / Math.sqrt(tangent_squared);
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const rho_raw = Math.sqrt(x * x + y * y),
      rho = ((rho_raw >= (1 / 1e+150) * eye) ? rho_raw : 0),
      discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette),
      root_a = Math.sqrt(maximum(0, discriminant_a)),
      rho_inverse = ((rho > 0) ? 1.0 / rho : 0),
      hit_scale = 1 / (radius * (eye * eye + root_a)),
      cos_theta = rho_inverse * x,
      sin_theta = rho_inverse * y,
      sin_phi = hit_scale * rho * tangent_squared,
      cos_phi = eye * hit_scale * (radius * radius + root_a),
      point_x = cos_theta * radius * sin_phi,
      point_y = radius * sin_phi * sin_theta,
      point_z = cos_phi * radius,
      segment_x = light_x - point_x,
      segment_y = light_y - point_y,
      segment_z = light_z - point_z,
      offset_x = center_x - point_x,
      offset_y = center_y - point_y,
      offset_z = center_z - point_z,
      segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z,
      toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z,
      shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y),
      occluded = (((segment_squared > toward_center) & (shadow_discriminant >= 0) & (toward_center > 0)) ? 1 : 0);
    occluded_row[i] = occluded;
  }
}

function shadow_on_b_row(
x_row, y, eye, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, light_x, light_y, light_z,
center_x, center_y, center_z, body_radius, occluded_row, start, stop
) {
  const distance = -ball_center_z + eye;
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const toward_b = ball_center_x * x + ball_center_y * y + distance * eye,
      discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y),
      root_b = Math.sqrt(maximum(0, discriminant_b)),
      t_b = (((ball_on > 0) & (discriminant_b >= 0) & (toward_b > 0)) ? (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b) : Infinity),
      point_x = t_b * x,
      point_y = t_b * y,
      point_z = eye * (1 - t_b),
      segment_x = light_x - point_x,
      segment_y = light_y - point_y,
      segment_z = light_z - point_z,
      offset_x = center_x - point_x,
      offset_y = center_y - point_y,
      offset_z = center_z - point_z,
      segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z,
      toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z,
      shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y),
      occluded = (((segment_squared > toward_center) & (shadow_discriminant >= 0) & (toward_center > 0)) ? 1 : 0);
    occluded_row[i] = occluded;
  }
}

function shadow_on_floor_row(x_row, y, light_x, light_y, light_z, center_x, center_y, center_z, body_radius, occluded_row, start, stop) {
  const point_y = y,
    point_z = 0,
    segment_y = light_y - point_y,
    segment_z = light_z - point_z,
    offset_y = center_y - point_y,
    offset_z = center_z - point_z;
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const point_x = x,
      segment_x = light_x - point_x,
      offset_x = center_x - point_x,
      segment_squared = segment_x * segment_x + segment_y * segment_y + segment_z * segment_z,
      toward_center = offset_x * segment_x + offset_y * segment_y + offset_z * segment_z,
      shadow_discriminant = body_radius * body_radius * segment_squared - (-offset_x * segment_y + offset_y * segment_x) * (-offset_x * segment_y + offset_y * segment_x) - (offset_x * segment_z - offset_z * segment_x) * (offset_x * segment_z - offset_z * segment_x) - (-offset_y * segment_z + offset_z * segment_y) * (-offset_y * segment_z + offset_z * segment_y),
      occluded = (((segment_squared > toward_center) & (shadow_discriminant >= 0) & (toward_center > 0)) ? 1 : 0);
    occluded_row[i] = occluded;
  }
}

function checker_row(x_row, y, dark_row, start, stop) {
  const point_y = y;
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const point_x = x,
      square = Math.floor(point_x) + Math.floor(point_y),
      dark = (((point_x !== Math.floor(point_x)) & (point_y !== Math.floor(point_y)) & (square !== 2 * Math.floor(0.5 * square))) ? 1 : 0);
    dark_row[i] = dark;
  }
}

function angles_on_a_row(x_row, y, eye, radius, cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, start, stop) {
  const tangent_squared = (eye - radius) * (eye + radius),
    rho_silhouette = eye * radius / Math.sqrt(tangent_squared);
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const rho_raw = Math.sqrt(x * x + y * y),
      rho = ((rho_raw >= (1 / 1e+150) * eye) ? rho_raw : 0),
      discriminant_a = tangent_squared * (-rho + rho_silhouette) * (rho + rho_silhouette),
      root_a = Math.sqrt(maximum(0, discriminant_a)),
      rho_inverse = ((rho > 0) ? 1.0 / rho : 0),
      hit_scale = 1 / (radius * (eye * eye + root_a)),
      cos_theta = rho_inverse * x,
      sin_theta = rho_inverse * y,
      sin_phi = hit_scale * rho * tangent_squared,
      cos_phi = eye * hit_scale * (radius * radius + root_a);
    cos_theta_row[i] = cos_theta;
    sin_theta_row[i] = sin_theta;
    cos_phi_row[i] = cos_phi;
    sin_phi_row[i] = sin_phi;
  }
}

function chart_row(cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, u_row, v_row, start, stop) {
  const [atan2pi_0, atan2pi_1] = spare_rows(2, stop);
  atan2pi_row(sin_theta_row, cos_theta_row, atan2pi_0, start, stop);
  atan2pi_row(sin_phi_row, cos_phi_row, atan2pi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const u_closed = 0.5 * atan2pi_0[i] + 0.5,
      u = ((u_closed < 1) ? u_closed : 0),
      v = atan2pi_1[i];
    u_row[i] = u;
    v_row[i] = v;
  }
}

function normal_on_a_row(
cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
point_x_row, point_y_row, point_z_row, bumped_x_row, bumped_y_row, bumped_z_row, view_scale_row, start, stop
) {
  const e_theta_z = 0;
  for (let i = start; i < stop; i++) {
    const cos_phi = cos_phi_row[i],
      cos_theta = cos_theta_row[i],
      h_u = h_u_row[i],
      h_v = h_v_row[i],
      sin_phi = sin_phi_row[i],
      sin_theta = sin_theta_row[i],
      x = x_row[i];
    const normal_x = cos_theta * sin_phi,
      normal_y = sin_phi * sin_theta,
      normal_z = cos_phi,
      e_theta_x = -sin_theta,
      e_theta_y = cos_theta,
      e_phi_x = cos_phi * cos_theta,
      e_phi_y = cos_phi * sin_theta,
      e_phi_z = -sin_phi,
      g_x = e_phi_x * h_v + e_theta_x * h_u,
      g_y = e_phi_y * h_v + e_theta_y * h_u,
      g_z = e_phi_z * h_v + e_theta_z * h_u,
      m_x = beta * g_x + normal_x,
      m_y = beta * g_y + normal_y,
      m_z = beta * g_z + normal_z,
      m_length = Math.sqrt(m_x * m_x + m_y * m_y + m_z * m_z),
      m_scale = 1.0 / m_length,
      bumped_x = m_scale * m_x,
      bumped_y = m_scale * m_y,
      bumped_z = m_scale * m_z,
      point_x = normal_x * radius,
      point_y = normal_y * radius,
      point_z = normal_z * radius,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y);
    point_x_row[i] = point_x;
    point_y_row[i] = point_y;
    point_z_row[i] = point_z;
    bumped_x_row[i] = bumped_x;
    bumped_y_row[i] = bumped_y;
    bumped_z_row[i] = bumped_z;
    view_scale_row[i] = view_scale;
  }
}

function normal_of_b_row(
x_row, y, eye, ball_center_x, ball_center_y, ball_center_z, ball_radius, ball_on, point_x_row, point_y_row,
point_z_row, bumped_x_row, bumped_y_row, bumped_z_row, view_scale_row, start, stop
) {
  const distance = -ball_center_z + eye;
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const toward_b = ball_center_x * x + ball_center_y * y + distance * eye,
      discriminant_b = ball_radius * ball_radius * (eye * eye + x * x + y * y) - (ball_center_x * eye - distance * x) * (ball_center_x * eye - distance * x) - (ball_center_x * y - ball_center_y * x) * (ball_center_x * y - ball_center_y * x) - (-ball_center_y * eye + distance * y) * (-ball_center_y * eye + distance * y),
      root_b = Math.sqrt(maximum(0, discriminant_b)),
      t_b = (((ball_on > 0) & (discriminant_b >= 0) & (toward_b > 0)) ? (ball_center_x * ball_center_x + ball_center_y * ball_center_y + (-ball_radius + distance) * (ball_radius + distance)) / (root_b + toward_b) : Infinity),
      point_x = t_b * x,
      point_y = t_b * y,
      point_z = eye * (1 - t_b),
      radius_vector_x = -ball_center_x + point_x,
      radius_vector_y = -ball_center_y + point_y,
      radius_vector_z = -ball_center_z + point_z,
      radius_length = Math.sqrt(radius_vector_x * radius_vector_x + radius_vector_y * radius_vector_y + radius_vector_z * radius_vector_z),
      normal_x = radius_vector_x / radius_length,
      normal_y = radius_vector_y / radius_length,
      normal_z = radius_vector_z / radius_length,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y);
    point_x_row[i] = point_x;
    point_y_row[i] = point_y;
    point_z_row[i] = point_z;
    bumped_x_row[i] = normal_x;
    bumped_y_row[i] = normal_y;
    bumped_z_row[i] = normal_z;
    view_scale_row[i] = view_scale;
  }
}

function view_length_row(x_row, y, eye, view_scale_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const x = x_row[i];
    const view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y);
    view_scale_row[i] = view_scale;
  }
}

function complex_square_row(real_part_row, imaginary_part_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const imaginary_part = imaginary_part_row[i],
      real_part = real_part_row[i];
    const product_real = (-imaginary_part + real_part) * (imaginary_part + real_part),
      product_imaginary = 2 * imaginary_part * real_part;
    real_part_row[i] = product_real;
    imaginary_part_row[i] = product_imaginary;
  }
}

function complex_product_row(real_part_row, imaginary_part_row, other_real_row, other_imaginary_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const imaginary_part = imaginary_part_row[i],
      other_imaginary = other_imaginary_row[i],
      other_real = other_real_row[i],
      real_part = real_part_row[i];
    const product_real = -imaginary_part * other_imaginary + other_real * real_part,
      product_imaginary = imaginary_part * other_real + other_imaginary * real_part;
    real_part_row[i] = product_real;
    imaginary_part_row[i] = product_imaginary;
  }
}

function square_row(base_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const base = base_row[i];
    const power = base * base;
    base_row[i] = power;
  }
}

function multiply_row(specular_row, base_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const base = base_row[i],
      specular = specular_row[i];
    const power = base * specular;
    specular_row[i] = power;
  }
}

function phong_row(
x_row, y, eye, view_scale_row, point_x_row, point_y_row, point_z_row, light_x, light_y, light_z, bumped_x_row,
bumped_y_row, bumped_z_row, mu_row, specular_base_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const bumped_x = bumped_x_row[i],
      bumped_y = bumped_y_row[i],
      bumped_z = bumped_z_row[i],
      point_x = point_x_row[i],
      point_y = point_y_row[i],
      point_z = point_z_row[i],
      view_scale = view_scale_row[i],
      x = x_row[i];
    const view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x = light_x - point_x,
      to_light_y = light_y - point_y,
      to_light_z = light_z - point_z,
      light_distance = Math.sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z),
      light_scale = 1.0 / light_distance,
      towards_x = light_scale * to_light_x,
      towards_y = light_scale * to_light_y,
      towards_z = light_scale * to_light_z,
      mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z,
      specular_base = maximum(0, 2 * mu * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x * view_x - towards_y * view_y - towards_z * view_z);
    mu_row[i] = mu;
    specular_base_row[i] = specular_base;
  }
}

function phong_on_floor_row(x_row, y, eye, view_scale_row, light_x, light_y, light_z, mu_row, specular_base_row, start, stop) {
  const to_light_y = light_y - y;
  for (let i = start; i < stop; i++) {
    const view_scale = view_scale_row[i],
      x = x_row[i];
    const view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x = light_x - x,
      light_distance = Math.sqrt(light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y),
      light_scale = 1.0 / light_distance,
      towards_x = light_scale * to_light_x,
      towards_y = light_scale * to_light_y,
      towards_z = light_scale * light_z,
      mu = towards_z,
      specular_base = maximum(0, 2 * mu * view_z - towards_x * view_x - towards_y * view_y - towards_z * view_z);
    mu_row[i] = mu;
    specular_base_row[i] = specular_base;
  }
}

function blinn_squared_row(
x_row, y, eye, view_scale_row, point_x_row, point_y_row, point_z_row, light_x, light_y, light_z, bumped_x_row,
bumped_y_row, bumped_z_row, mu_row, specular_base_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const bumped_x = bumped_x_row[i],
      bumped_y = bumped_y_row[i],
      bumped_z = bumped_z_row[i],
      point_x = point_x_row[i],
      point_y = point_y_row[i],
      point_z = point_z_row[i],
      view_scale = view_scale_row[i],
      x = x_row[i];
    const view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x = light_x - point_x,
      to_light_y = light_y - point_y,
      to_light_z = light_z - point_z,
      distance_squared = to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z,
      light_distance = Math.sqrt(distance_squared),
      halfway_x = light_distance * view_x + to_light_x,
      halfway_y = light_distance * view_y + to_light_y,
      halfway_z = light_distance * view_z + to_light_z,
      halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z,
      along_light = bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z,
      along_halfway = maximum(0, bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z),
      light_scale = ((halfway_squared > 0) ? 1 / (halfway_squared * light_distance) : 0),
      mu = ((halfway_squared > 0) ? along_light * halfway_squared * light_scale : -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z),
      specular_base = along_halfway * along_halfway * light_distance * light_scale;
    mu_row[i] = mu;
    specular_base_row[i] = specular_base;
  }
}

function blinn_squared_on_floor_row(x_row, y, eye, view_scale_row, light_x, light_y, light_z, mu_row, specular_base_row, start, stop) {
  const to_light_y = light_y - y;
  for (let i = start; i < stop; i++) {
    const view_scale = view_scale_row[i],
      x = x_row[i];
    const view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x = light_x - x,
      distance_squared = light_z * light_z + to_light_x * to_light_x + to_light_y * to_light_y,
      light_distance = Math.sqrt(distance_squared),
      halfway_x = light_distance * view_x + to_light_x,
      halfway_y = light_distance * view_y + to_light_y,
      halfway_z = light_distance * view_z + light_z,
      halfway_squared = halfway_x * halfway_x + halfway_y * halfway_y + halfway_z * halfway_z,
      along_halfway = maximum(0, halfway_z),
      light_scale = ((halfway_squared > 0) ? 1 / (halfway_squared * light_distance) : 0),
      mu = ((halfway_squared > 0) ? halfway_squared * light_scale * light_z : -view_z),
      specular_base = along_halfway * along_halfway * light_distance * light_scale;
    mu_row[i] = mu;
    specular_base_row[i] = specular_base;
  }
}

function light_cosine_row(
point_x_row, point_y_row, point_z_row, light_x, light_y, light_z, bumped_x_row, bumped_y_row, bumped_z_row,
mu_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const bumped_x = bumped_x_row[i],
      bumped_y = bumped_y_row[i],
      bumped_z = bumped_z_row[i],
      point_x = point_x_row[i],
      point_y = point_y_row[i],
      point_z = point_z_row[i];
    const to_light_x = light_x - point_x,
      to_light_y = light_y - point_y,
      to_light_z = light_z - point_z,
      light_distance = Math.sqrt(to_light_x * to_light_x + to_light_y * to_light_y + to_light_z * to_light_z),
      light_scale = 1.0 / light_distance,
      towards_x = light_scale * to_light_x,
      towards_y = light_scale * to_light_y,
      towards_z = light_scale * to_light_z,
      mu = bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z;
    mu_row[i] = mu;
  }
}

function light_term_row(
red_row, green_row, blue_row, light_red, light_green, light_blue, albedo_red, albedo_green, albedo_blue, kd, ks,
mu_row, specular_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const blue = blue_row[i],
      green = green_row[i],
      mu = mu_row[i],
      red = red_row[i],
      specular = specular_row[i];
    const diffuse = kd * maximum(0, mu),
      shine = ks * specular,
      lit_red = light_red * (albedo_red * diffuse + shine) + red,
      lit_green = green + light_green * (albedo_green * diffuse + shine),
      lit_blue = blue + light_blue * (albedo_blue * diffuse + shine);
    red_row[i] = lit_red;
    green_row[i] = lit_green;
    blue_row[i] = lit_blue;
  }
}

function clip_row(red_row, green_row, blue_row, lit_red_row, lit_green_row, lit_blue_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const blue = blue_row[i],
      green = green_row[i],
      red = red_row[i];
    const lit_red = minimum(1, maximum(0, red)),
      lit_green = minimum(1, maximum(0, green)),
      lit_blue = minimum(1, maximum(0, blue));
    lit_red_row[i] = lit_red;
    lit_green_row[i] = lit_green;
    lit_blue_row[i] = lit_blue;
  }
}

function slope_row(h_u_row, h_v_row, slope_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const h_u = h_u_row[i],
      h_v = h_v_row[i];
    const slope = Math.sqrt(h_u * h_u + h_v * h_v);
    slope_row[i] = slope;
  }
}

function phong_of_1_on_a_row(
cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const cos_phi = cos_phi_row[i],
      cos_theta = cos_theta_row[i],
      h_u = h_u_row[i],
      h_v = h_v_row[i],
      sin_phi = sin_phi_row[i],
      sin_theta = sin_theta_row[i],
      x = x_row[i];
    const normal_x = cos_theta * sin_phi,
      normal_y = sin_phi * sin_theta,
      e_theta_x = -sin_theta,
      e_phi_x = cos_phi * cos_theta,
      e_phi_y = cos_phi * sin_theta,
      e_phi_z = -sin_phi,
      g_x = e_phi_x * h_v + e_theta_x * h_u,
      g_y = cos_theta * h_u + e_phi_y * h_v,
      g_z = e_phi_z * h_v,
      m_x = beta * g_x + normal_x,
      m_y = beta * g_y + normal_y,
      m_z = beta * g_z + cos_phi,
      m_length = Math.sqrt(m_x * m_x + m_y * m_y + m_z * m_z),
      m_scale = 1.0 / m_length,
      bumped_x = m_scale * m_x,
      bumped_y = m_scale * m_y,
      bumped_z = m_scale * m_z,
      point_x = normal_x * radius,
      point_y = normal_y * radius,
      point_z = cos_phi * radius,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y),
      view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x_1 = light_x_1 - point_x,
      to_light_y_1 = light_y_1 - point_y,
      to_light_z_1 = light_z_1 - point_z,
      light_distance_1 = Math.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1),
      light_scale_1 = 1.0 / light_distance_1,
      towards_x_1 = light_scale_1 * to_light_x_1,
      towards_y_1 = light_scale_1 * to_light_y_1,
      towards_z_1 = light_scale_1 * to_light_z_1,
      mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1,
      specular_base_1 = maximum(0, 2 * mu_1 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z);
    mu_1_row[i] = mu_1;
    specular_base_1_row[i] = specular_base_1;
  }
}

function phong_of_2_on_a_row(
cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, specular_base_1_row, mu_2_row,
specular_base_2_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const cos_phi = cos_phi_row[i],
      cos_theta = cos_theta_row[i],
      h_u = h_u_row[i],
      h_v = h_v_row[i],
      sin_phi = sin_phi_row[i],
      sin_theta = sin_theta_row[i],
      x = x_row[i];
    const normal_x = cos_theta * sin_phi,
      normal_y = sin_phi * sin_theta,
      e_theta_x = -sin_theta,
      e_phi_x = cos_phi * cos_theta,
      e_phi_y = cos_phi * sin_theta,
      e_phi_z = -sin_phi,
      g_x = e_phi_x * h_v + e_theta_x * h_u,
      g_y = cos_theta * h_u + e_phi_y * h_v,
      g_z = e_phi_z * h_v,
      m_x = beta * g_x + normal_x,
      m_y = beta * g_y + normal_y,
      m_z = beta * g_z + cos_phi,
      m_length = Math.sqrt(m_x * m_x + m_y * m_y + m_z * m_z),
      m_scale = 1.0 / m_length,
      bumped_x = m_scale * m_x,
      bumped_y = m_scale * m_y,
      bumped_z = m_scale * m_z,
      point_x = normal_x * radius,
      point_y = normal_y * radius,
      point_z = cos_phi * radius,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y),
      view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x_1 = light_x_1 - point_x,
      to_light_y_1 = light_y_1 - point_y,
      to_light_z_1 = light_z_1 - point_z,
      light_distance_1 = Math.sqrt(to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1),
      light_scale_1 = 1.0 / light_distance_1,
      towards_x_1 = light_scale_1 * to_light_x_1,
      towards_y_1 = light_scale_1 * to_light_y_1,
      towards_z_1 = light_scale_1 * to_light_z_1,
      mu_1 = bumped_x * towards_x_1 + bumped_y * towards_y_1 + bumped_z * towards_z_1,
      specular_base_1 = maximum(0, 2 * mu_1 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_1 * view_x - towards_y_1 * view_y - towards_z_1 * view_z),
      to_light_x_2 = light_x_2 - point_x,
      to_light_y_2 = light_y_2 - point_y,
      to_light_z_2 = light_z_2 - point_z,
      light_distance_2 = Math.sqrt(to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2),
      light_scale_2 = 1.0 / light_distance_2,
      towards_x_2 = light_scale_2 * to_light_x_2,
      towards_y_2 = light_scale_2 * to_light_y_2,
      towards_z_2 = light_scale_2 * to_light_z_2,
      mu_2 = bumped_x * towards_x_2 + bumped_y * towards_y_2 + bumped_z * towards_z_2,
      specular_base_2 = maximum(0, 2 * mu_2 * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x_2 * view_x - towards_y_2 * view_y - towards_z_2 * view_z);
    mu_1_row[i] = mu_1;
    specular_base_1_row[i] = specular_base_1;
    mu_2_row[i] = mu_2;
    specular_base_2_row[i] = specular_base_2;
  }
}

function squared_of_1_on_a_row(
cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
light_x_1, light_y_1, light_z_1, mu_1_row, specular_base_1_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const cos_phi = cos_phi_row[i],
      cos_theta = cos_theta_row[i],
      h_u = h_u_row[i],
      h_v = h_v_row[i],
      sin_phi = sin_phi_row[i],
      sin_theta = sin_theta_row[i],
      x = x_row[i];
    const normal_x = cos_theta * sin_phi,
      normal_y = sin_phi * sin_theta,
      e_theta_x = -sin_theta,
      e_phi_x = cos_phi * cos_theta,
      e_phi_y = cos_phi * sin_theta,
      e_phi_z = -sin_phi,
      g_x = e_phi_x * h_v + e_theta_x * h_u,
      g_y = cos_theta * h_u + e_phi_y * h_v,
      g_z = e_phi_z * h_v,
      m_x = beta * g_x + normal_x,
      m_y = beta * g_y + normal_y,
      m_z = beta * g_z + cos_phi,
      m_length = Math.sqrt(m_x * m_x + m_y * m_y + m_z * m_z),
      m_scale = 1.0 / m_length,
      bumped_x = m_scale * m_x,
      bumped_y = m_scale * m_y,
      bumped_z = m_scale * m_z,
      point_x = normal_x * radius,
      point_y = normal_y * radius,
      point_z = cos_phi * radius,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y),
      view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x_1 = light_x_1 - point_x,
      to_light_y_1 = light_y_1 - point_y,
      to_light_z_1 = light_z_1 - point_z,
      distance_squared_1 = to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1,
      light_distance_1 = Math.sqrt(distance_squared_1),
      halfway_x_1 = light_distance_1 * view_x + to_light_x_1,
      halfway_y_1 = light_distance_1 * view_y + to_light_y_1,
      halfway_z_1 = light_distance_1 * view_z + to_light_z_1,
      halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1,
      along_light_1 = bumped_x * to_light_x_1 + bumped_y * to_light_y_1 + bumped_z * to_light_z_1,
      along_halfway_1 = maximum(0, bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1),
      light_scale_1 = ((halfway_squared_1 > 0) ? 1 / (halfway_squared_1 * light_distance_1) : 0),
      mu_1 = ((halfway_squared_1 > 0) ? along_light_1 * halfway_squared_1 * light_scale_1 : -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z),
      specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1;
    mu_1_row[i] = mu_1;
    specular_base_1_row[i] = specular_base_1;
  }
}

function squared_of_2_on_a_row(
cos_theta_row, sin_theta_row, cos_phi_row, sin_phi_row, h_u_row, h_v_row, beta, radius, x_row, y, eye,
light_x_1, light_y_1, light_z_1, light_x_2, light_y_2, light_z_2, mu_1_row, specular_base_1_row, mu_2_row,
specular_base_2_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const cos_phi = cos_phi_row[i],
      cos_theta = cos_theta_row[i],
      h_u = h_u_row[i],
      h_v = h_v_row[i],
      sin_phi = sin_phi_row[i],
      sin_theta = sin_theta_row[i],
      x = x_row[i];
    const normal_x = cos_theta * sin_phi,
      normal_y = sin_phi * sin_theta,
      e_theta_x = -sin_theta,
      e_phi_x = cos_phi * cos_theta,
      e_phi_y = cos_phi * sin_theta,
      e_phi_z = -sin_phi,
      g_x = e_phi_x * h_v + e_theta_x * h_u,
      g_y = cos_theta * h_u + e_phi_y * h_v,
      g_z = e_phi_z * h_v,
      m_x = beta * g_x + normal_x,
      m_y = beta * g_y + normal_y,
      m_z = beta * g_z + cos_phi,
      m_length = Math.sqrt(m_x * m_x + m_y * m_y + m_z * m_z),
      m_scale = 1.0 / m_length,
      bumped_x = m_scale * m_x,
      bumped_y = m_scale * m_y,
      bumped_z = m_scale * m_z,
      point_x = normal_x * radius,
      point_y = normal_y * radius,
      point_z = cos_phi * radius,
      view_scale = 1.0 / Math.sqrt(eye * eye + x * x + y * y),
      view_x = -view_scale * x,
      view_y = -view_scale * y,
      view_z = eye * view_scale,
      to_light_x_1 = light_x_1 - point_x,
      to_light_y_1 = light_y_1 - point_y,
      to_light_z_1 = light_z_1 - point_z,
      distance_squared_1 = to_light_x_1 * to_light_x_1 + to_light_y_1 * to_light_y_1 + to_light_z_1 * to_light_z_1,
      light_distance_1 = Math.sqrt(distance_squared_1),
      halfway_x_1 = light_distance_1 * view_x + to_light_x_1,
      halfway_y_1 = light_distance_1 * view_y + to_light_y_1,
      halfway_z_1 = light_distance_1 * view_z + to_light_z_1,
      halfway_squared_1 = halfway_x_1 * halfway_x_1 + halfway_y_1 * halfway_y_1 + halfway_z_1 * halfway_z_1,
      along_light_1 = bumped_x * to_light_x_1 + bumped_y * to_light_y_1 + bumped_z * to_light_z_1,
      along_halfway_1 = maximum(0, bumped_x * halfway_x_1 + bumped_y * halfway_y_1 + bumped_z * halfway_z_1),
      light_scale_1 = ((halfway_squared_1 > 0) ? 1 / (halfway_squared_1 * light_distance_1) : 0),
      mu_1 = ((halfway_squared_1 > 0) ? along_light_1 * halfway_squared_1 * light_scale_1 : -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z),
      specular_base_1 = along_halfway_1 * along_halfway_1 * light_distance_1 * light_scale_1,
      to_light_x_2 = light_x_2 - point_x,
      to_light_y_2 = light_y_2 - point_y,
      to_light_z_2 = light_z_2 - point_z,
      distance_squared_2 = to_light_x_2 * to_light_x_2 + to_light_y_2 * to_light_y_2 + to_light_z_2 * to_light_z_2,
      light_distance_2 = Math.sqrt(distance_squared_2),
      halfway_x_2 = light_distance_2 * view_x + to_light_x_2,
      halfway_y_2 = light_distance_2 * view_y + to_light_y_2,
      halfway_z_2 = light_distance_2 * view_z + to_light_z_2,
      halfway_squared_2 = halfway_x_2 * halfway_x_2 + halfway_y_2 * halfway_y_2 + halfway_z_2 * halfway_z_2,
      along_light_2 = bumped_x * to_light_x_2 + bumped_y * to_light_y_2 + bumped_z * to_light_z_2,
      along_halfway_2 = maximum(0, bumped_x * halfway_x_2 + bumped_y * halfway_y_2 + bumped_z * halfway_z_2),
      light_scale_2 = ((halfway_squared_2 > 0) ? 1 / (halfway_squared_2 * light_distance_2) : 0),
      mu_2 = ((halfway_squared_2 > 0) ? along_light_2 * halfway_squared_2 * light_scale_2 : -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z),
      specular_base_2 = along_halfway_2 * along_halfway_2 * light_distance_2 * light_scale_2;
    mu_1_row[i] = mu_1;
    specular_base_1_row[i] = specular_base_1;
    mu_2_row[i] = mu_2;
    specular_base_2_row[i] = specular_base_2;
  }
}

function light_terms_of_1_on_sphere_row(
red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green, albedo_blue, kd, ks,
mu_1_row, specular_1_row, lit_red_1_row, lit_green_1_row, lit_blue_1_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const mu_1 = mu_1_row[i],
      specular_1 = specular_1_row[i];
    const diffuse_1 = kd * maximum(0, mu_1),
      shine_1 = ks * specular_1,
      lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red,
      lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1),
      lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1);
    lit_red_1_row[i] = lit_red_1;
    lit_green_1_row[i] = lit_green_1;
    lit_blue_1_row[i] = lit_blue_1;
  }
}

function light_terms_of_2_on_sphere_row(
red, green, blue, light_red_1, light_green_1, light_blue_1, albedo_red, albedo_green, albedo_blue, kd, ks,
mu_1_row, specular_1_row, light_red_2, light_green_2, light_blue_2, mu_2_row, specular_2_row, lit_red_2_row,
lit_green_2_row, lit_blue_2_row, start, stop
) {
  for (let i = start; i < stop; i++) {
    const mu_1 = mu_1_row[i],
      mu_2 = mu_2_row[i],
      specular_1 = specular_1_row[i],
      specular_2 = specular_2_row[i];
    const diffuse_1 = kd * maximum(0, mu_1),
      shine_1 = ks * specular_1,
      lit_red_1 = light_red_1 * (albedo_red * diffuse_1 + shine_1) + red,
      lit_green_1 = green + light_green_1 * (albedo_green * diffuse_1 + shine_1),
      lit_blue_1 = blue + light_blue_1 * (albedo_blue * diffuse_1 + shine_1),
      diffuse_2 = kd * maximum(0, mu_2),
      shine_2 = ks * specular_2,
      lit_red_2 = light_red_2 * (albedo_red * diffuse_2 + shine_2) + lit_red_1,
      lit_green_2 = light_green_2 * (albedo_green * diffuse_2 + shine_2) + lit_green_1,
      lit_blue_2 = light_blue_2 * (albedo_blue * diffuse_2 + shine_2) + lit_blue_1;
    lit_red_2_row[i] = lit_red_2;
    lit_green_2_row[i] = lit_green_2;
    lit_blue_2_row[i] = lit_blue_2;
  }
}

function height_sine_row(u_row, v_row, k_u, k_v, h_row, start, stop) {
  const [sinpi_0, sinpi_1] = spare_rows(2, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const h = sinpi_0[i] * sinpi_1[i];
    h_row[i] = h;
  }
}

function gradient_sine_row(u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  const [cospi_0, cospi_1, sinpi_2, sinpi_3] = spare_rows(4, stop);
  cospi_of_product_row(k_u, u_row, cospi_0, start, stop);
  cospi_of_product_row(k_v, v_row, cospi_1, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_3, start, stop);
  for (let i = start; i < stop; i++) {
    const cos_u = cospi_0[i],
      cos_v = cospi_1[i],
      sin_u = sinpi_2[i],
      sin_v = sinpi_3[i],
      h_u = Math.PI * cos_u * k_u * sin_v,
      h_v = Math.PI * cos_v * k_v * sin_u;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function kink_sine_row(sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const sin_phi = sin_phi_row[i];
    const kink = ((sin_phi <= 0) ? 1 : 0);
    kink_row[i] = kink;
  }
}

function straddling_sine_row(u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop) {
  const straddles = 0;
  for (let i = start; i < stop; i++) {
    straddles_row[i] = straddles;
  }
}

function forward_sine_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [stepped_row, u_plus_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3] = spare_rows(6, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      stepped = ((epsilon + v <= 1) ? epsilon + v : -epsilon + v);
    stepped_row[i] = stepped;
    u_plus_row[i] = u_plus;
  }
  sinpi_of_product_row(k_u, u_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_plus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_v, stepped_row, sinpi_3, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const h_here = sinpi_0[i] * sinpi_1[i],
      h_u_plus = sinpi_2[i] * sinpi_1[i],
      h_v_plus = sinpi_0[i] * sinpi_3[i],
      h_u = (-h_here + h_u_plus) / epsilon,
      h_v = ((epsilon + v <= 1) ? (-h_here + h_v_plus) / epsilon : (h_here - h_v_plus) / epsilon);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central_sine_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [u_minus_row, u_plus_row, v_minus_row, v_plus_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3, sinpi_4, sinpi_5] = spare_rows(10, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      u_minus = -epsilon + u - Math.floor(-epsilon + u),
      v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v);
    u_minus_row[i] = u_minus;
    u_plus_row[i] = u_plus;
    v_minus_row[i] = v_minus;
    v_plus_row[i] = v_plus;
  }
  sinpi_of_product_row(k_u, u_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_minus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_3, start, stop);
  sinpi_of_product_row(k_v, v_plus_row, sinpi_4, start, stop);
  sinpi_of_product_row(k_v, v_minus_row, sinpi_5, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_u_plus = sinpi_0[i] * sinpi_1[i],
      h_u_minus = sinpi_2[i] * sinpi_1[i],
      h_v_plus = sinpi_3[i] * sinpi_4[i],
      h_v_minus = sinpi_3[i] * sinpi_5[i],
      h_u = 0.5 * (-h_u_minus + h_u_plus) / epsilon,
      h_v = (-h_v_minus + h_v_plus) / span_v;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central4_sine_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [u_minus_row, u_minus_2_row, u_plus_row, u_plus_2_row, v_minus_row, v_minus_2_row, v_plus_row, v_plus_2_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3, sinpi_4, sinpi_5, sinpi_6, sinpi_7, sinpi_8, sinpi_9] = spare_rows(18, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      u_minus = -epsilon + u - Math.floor(-epsilon + u),
      v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      u_plus_2 = 2 * epsilon + u - Math.floor(2 * epsilon + u),
      u_minus_2 = -2 * epsilon + u - Math.floor(-2 * epsilon + u),
      v_plus_2 = minimum(1, 2 * epsilon + v),
      v_minus_2 = maximum(0, -2 * epsilon + v);
    u_minus_row[i] = u_minus;
    u_minus_2_row[i] = u_minus_2;
    u_plus_row[i] = u_plus;
    u_plus_2_row[i] = u_plus_2;
    v_minus_row[i] = v_minus;
    v_minus_2_row[i] = v_minus_2;
    v_plus_row[i] = v_plus;
    v_plus_2_row[i] = v_plus_2;
  }
  sinpi_of_product_row(k_u, u_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_minus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_3, start, stop);
  sinpi_of_product_row(k_v, v_plus_row, sinpi_4, start, stop);
  sinpi_of_product_row(k_v, v_minus_row, sinpi_5, start, stop);
  sinpi_of_product_row(k_u, u_plus_2_row, sinpi_6, start, stop);
  sinpi_of_product_row(k_u, u_minus_2_row, sinpi_7, start, stop);
  sinpi_of_product_row(k_v, v_plus_2_row, sinpi_8, start, stop);
  sinpi_of_product_row(k_v, v_minus_2_row, sinpi_9, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_u_plus = sinpi_0[i] * sinpi_1[i],
      h_u_minus = sinpi_2[i] * sinpi_1[i],
      h_v_plus = sinpi_3[i] * sinpi_4[i],
      h_v_minus = sinpi_3[i] * sinpi_5[i],
      h_u_plus_2 = sinpi_6[i] * sinpi_1[i],
      h_u_minus_2 = sinpi_7[i] * sinpi_1[i],
      h_v_plus_2 = sinpi_3[i] * sinpi_8[i],
      h_v_minus_2 = sinpi_3[i] * sinpi_9[i],
      near_difference_u = -h_u_minus + h_u_plus,
      h_u = (1 / 12) * (h_u_minus_2 - h_u_plus_2 + 8 * near_difference_u) / epsilon,
      near_difference_v = -h_v_minus + h_v_plus,
      h_v = (((2 * epsilon + v <= 1) & (2 * epsilon - v <= 0)) ? (1 / 12) * (h_v_minus_2 - h_v_plus_2 + 8 * near_difference_v) / epsilon : near_difference_v / span_v);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function gradient_from_factors_sine_row(sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const cos_u = cos_u_row[i],
      cos_v = cos_v_row[i],
      sin_u = sin_u_row[i],
      sin_v = sin_v_row[i];
    const h_u = Math.PI * cos_u * k_u * sin_v,
      h_v = Math.PI * cos_v * k_v * sin_u;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function wave_numbers_sine(k_u, k_v) {
  const a = k_u,
    b = k_v;
  return [a, b];
}

function height_ridges_row(u_row, v_row, k_u, k_v, h_row, start, stop) {
  const [sinpi_0, sinpi_1] = spare_rows(2, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const h = Math.abs(sinpi_0[i] * sinpi_1[i]);
    h_row[i] = h;
  }
}

function gradient_ridges_row(u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  const [cospi_0, cospi_1, sinpi_2, sinpi_3] = spare_rows(4, stop);
  cospi_of_product_row(k_u, u_row, cospi_0, start, stop);
  cospi_of_product_row(k_v, v_row, cospi_1, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_3, start, stop);
  for (let i = start; i < stop; i++) {
    const cos_u = cospi_0[i],
      cos_v = cospi_1[i],
      sin_u = sinpi_2[i],
      sin_v = sinpi_3[i],
      h_u = Math.PI * cos_u * k_u * sin_v * (sign(sin_u) * sign(sin_v)),
      h_v = Math.PI * cos_v * k_v * sin_u * (sign(sin_u) * sign(sin_v));
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function kink_ridges_row(sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop) {
  const [sinpi_0, sinpi_1] = spare_rows(2, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const sin_phi = sin_phi_row[i];
    const kink = (((Math.abs(sinpi_0[i]) < (3 / 100)) | (Math.abs(sinpi_1[i]) < (3 / 100)) | (sin_phi <= 0)) ? 1 : 0);
    kink_row[i] = kink;
  }
}

function straddling_ridges_row(u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const crease_distance_0 = Math.abs(k_u * u - rint(k_u * u)),
      crease_distance_1 = Math.abs(k_v * v - rint(k_v * v)),
      straddles = (((crease_distance_0 < epsilon * Math.abs(k_u)) | (crease_distance_1 < epsilon * Math.abs(k_v))) ? 1 : 0);
    straddles_row[i] = straddles;
  }
}

function forward_ridges_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [stepped_row, u_plus_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3] = spare_rows(6, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      stepped = ((epsilon + v <= 1) ? epsilon + v : -epsilon + v);
    stepped_row[i] = stepped;
    u_plus_row[i] = u_plus;
  }
  sinpi_of_product_row(k_u, u_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_plus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_v, stepped_row, sinpi_3, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const h_here = Math.abs(sinpi_0[i] * sinpi_1[i]),
      h_u_plus = Math.abs(sinpi_2[i] * sinpi_1[i]),
      h_v_plus = Math.abs(sinpi_0[i] * sinpi_3[i]),
      h_u = (-h_here + h_u_plus) / epsilon,
      h_v = ((epsilon + v <= 1) ? (-h_here + h_v_plus) / epsilon : (h_here - h_v_plus) / epsilon);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central_ridges_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [u_minus_row, u_plus_row, v_minus_row, v_plus_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3, sinpi_4, sinpi_5] = spare_rows(10, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      u_minus = -epsilon + u - Math.floor(-epsilon + u),
      v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v);
    u_minus_row[i] = u_minus;
    u_plus_row[i] = u_plus;
    v_minus_row[i] = v_minus;
    v_plus_row[i] = v_plus;
  }
  sinpi_of_product_row(k_u, u_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_minus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_3, start, stop);
  sinpi_of_product_row(k_v, v_plus_row, sinpi_4, start, stop);
  sinpi_of_product_row(k_v, v_minus_row, sinpi_5, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_u_plus = Math.abs(sinpi_0[i] * sinpi_1[i]),
      h_u_minus = Math.abs(sinpi_2[i] * sinpi_1[i]),
      h_v_plus = Math.abs(sinpi_3[i] * sinpi_4[i]),
      h_v_minus = Math.abs(sinpi_3[i] * sinpi_5[i]),
      h_u = 0.5 * (-h_u_minus + h_u_plus) / epsilon,
      h_v = (-h_v_minus + h_v_plus) / span_v;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central4_ridges_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const [u_minus_row, u_minus_2_row, u_plus_row, u_plus_2_row, v_minus_row, v_minus_2_row, v_plus_row, v_plus_2_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3, sinpi_4, sinpi_5, sinpi_6, sinpi_7, sinpi_8, sinpi_9] = spare_rows(18, stop);
  for (let i = start; i < stop; i++) {
    const u = u_row[i],
      v = v_row[i];
    const u_plus = epsilon + u - Math.floor(epsilon + u),
      u_minus = -epsilon + u - Math.floor(-epsilon + u),
      v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      u_plus_2 = 2 * epsilon + u - Math.floor(2 * epsilon + u),
      u_minus_2 = -2 * epsilon + u - Math.floor(-2 * epsilon + u),
      v_plus_2 = minimum(1, 2 * epsilon + v),
      v_minus_2 = maximum(0, -2 * epsilon + v);
    u_minus_row[i] = u_minus;
    u_minus_2_row[i] = u_minus_2;
    u_plus_row[i] = u_plus;
    u_plus_2_row[i] = u_plus_2;
    v_minus_row[i] = v_minus;
    v_minus_2_row[i] = v_minus_2;
    v_plus_row[i] = v_plus;
    v_plus_2_row[i] = v_plus_2;
  }
  sinpi_of_product_row(k_u, u_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(k_v, v_row, sinpi_1, start, stop);
  sinpi_of_product_row(k_u, u_minus_row, sinpi_2, start, stop);
  sinpi_of_product_row(k_u, u_row, sinpi_3, start, stop);
  sinpi_of_product_row(k_v, v_plus_row, sinpi_4, start, stop);
  sinpi_of_product_row(k_v, v_minus_row, sinpi_5, start, stop);
  sinpi_of_product_row(k_u, u_plus_2_row, sinpi_6, start, stop);
  sinpi_of_product_row(k_u, u_minus_2_row, sinpi_7, start, stop);
  sinpi_of_product_row(k_v, v_plus_2_row, sinpi_8, start, stop);
  sinpi_of_product_row(k_v, v_minus_2_row, sinpi_9, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_u_plus = Math.abs(sinpi_0[i] * sinpi_1[i]),
      h_u_minus = Math.abs(sinpi_2[i] * sinpi_1[i]),
      h_v_plus = Math.abs(sinpi_3[i] * sinpi_4[i]),
      h_v_minus = Math.abs(sinpi_3[i] * sinpi_5[i]),
      h_u_plus_2 = Math.abs(sinpi_6[i] * sinpi_1[i]),
      h_u_minus_2 = Math.abs(sinpi_7[i] * sinpi_1[i]),
      h_v_plus_2 = Math.abs(sinpi_3[i] * sinpi_8[i]),
      h_v_minus_2 = Math.abs(sinpi_3[i] * sinpi_9[i]),
      near_difference_u = -h_u_minus + h_u_plus,
      h_u = (1 / 12) * (h_u_minus_2 - h_u_plus_2 + 8 * near_difference_u) / epsilon,
      near_difference_v = -h_v_minus + h_v_plus,
      h_v = (((2 * epsilon + v <= 1) & (2 * epsilon - v <= 0)) ? (1 / 12) * (h_v_minus_2 - h_v_plus_2 + 8 * near_difference_v) / epsilon : near_difference_v / span_v);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function gradient_from_factors_ridges_row(sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const cos_u = cos_u_row[i],
      cos_v = cos_v_row[i],
      sin_u = sin_u_row[i],
      sin_v = sin_v_row[i];
    const h_u = Math.PI * cos_u * k_u * sin_v * (sign(sin_u) * sign(sin_v)),
      h_v = Math.PI * cos_v * k_v * sin_u * (sign(sin_u) * sign(sin_v));
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function wave_numbers_ridges(k_u, k_v) {
  const a = k_u,
    b = k_v;
  return [a, b];
}

function height_rings_row(u_row, v_row, k_u, k_v, h_row, start, stop) {
  const [sinpi_0] = spare_rows(1, stop);
  sinpi_of_product_row(2 * k_v, v_row, sinpi_0, start, stop);
  for (let i = start; i < stop; i++) {
    const h = sinpi_0[i];
    h_row[i] = h;
  }
}

function gradient_rings_row(u_row, v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  const h_u = 0;
  const [cospi_0, sinpi_1] = spare_rows(2, stop);
  cospi_of_product_row(2 * k_v, v_row, cospi_0, start, stop);
  sinpi_of_product_row(2 * k_v, v_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const cos_v = cospi_0[i],
      h_v = 2 * Math.PI * cos_v * k_v;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function kink_rings_row(sin_phi_row, u_row, v_row, k_u, k_v, kink_row, start, stop) {
  for (let i = start; i < stop; i++) {
    const sin_phi = sin_phi_row[i];
    const kink = ((sin_phi <= 0) ? 1 : 0);
    kink_row[i] = kink;
  }
}

function straddling_rings_row(u_row, v_row, k_u, k_v, epsilon, straddles_row, start, stop) {
  const straddles = 0;
  for (let i = start; i < stop; i++) {
    straddles_row[i] = straddles;
  }
}

function forward_rings_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const h_u = 0;
  const [stepped_row, sinpi_0, sinpi_1] = spare_rows(3, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const stepped = ((epsilon + v <= 1) ? epsilon + v : -epsilon + v);
    stepped_row[i] = stepped;
  }
  sinpi_of_product_row(2 * k_v, v_row, sinpi_0, start, stop);
  sinpi_of_product_row(2 * k_v, stepped_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const h_here = sinpi_0[i],
      h_v_plus = sinpi_1[i],
      h_v = ((epsilon + v <= 1) ? (-h_here + h_v_plus) / epsilon : (h_here - h_v_plus) / epsilon);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central_rings_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const h_u = 0;
  const [v_minus_row, v_plus_row, sinpi_0, sinpi_1] = spare_rows(4, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v);
    v_minus_row[i] = v_minus;
    v_plus_row[i] = v_plus;
  }
  sinpi_of_product_row(2 * k_v, v_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(2 * k_v, v_minus_row, sinpi_1, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_v_plus = sinpi_0[i],
      h_v_minus = sinpi_1[i],
      h_v = (-h_v_minus + h_v_plus) / span_v;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function central4_rings_row(u_row, v_row, k_u, k_v, epsilon, h_u_row, h_v_row, start, stop) {
  const h_u = 0;
  const [v_minus_row, v_minus_2_row, v_plus_row, v_plus_2_row, sinpi_0, sinpi_1, sinpi_2, sinpi_3] = spare_rows(8, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      v_plus_2 = minimum(1, 2 * epsilon + v),
      v_minus_2 = maximum(0, -2 * epsilon + v);
    v_minus_row[i] = v_minus;
    v_minus_2_row[i] = v_minus_2;
    v_plus_row[i] = v_plus;
    v_plus_2_row[i] = v_plus_2;
  }
  sinpi_of_product_row(2 * k_v, v_plus_row, sinpi_0, start, stop);
  sinpi_of_product_row(2 * k_v, v_minus_row, sinpi_1, start, stop);
  sinpi_of_product_row(2 * k_v, v_plus_2_row, sinpi_2, start, stop);
  sinpi_of_product_row(2 * k_v, v_minus_2_row, sinpi_3, start, stop);
  for (let i = start; i < stop; i++) {
    const v = v_row[i];
    const v_plus = minimum(1, epsilon + v),
      v_minus = maximum(0, -epsilon + v),
      span_v = (((epsilon + v <= 1) & (epsilon - v <= 0)) ? 2 * epsilon : -v_minus + v_plus),
      h_v_plus = sinpi_0[i],
      h_v_minus = sinpi_1[i],
      h_v_plus_2 = sinpi_2[i],
      h_v_minus_2 = sinpi_3[i],
      near_difference_v = -h_v_minus + h_v_plus,
      h_v = (((2 * epsilon + v <= 1) & (2 * epsilon - v <= 0)) ? (1 / 12) * (h_v_minus_2 - h_v_plus_2 + 8 * near_difference_v) / epsilon : near_difference_v / span_v);
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function gradient_from_factors_rings_row(sin_u_row, cos_u_row, sin_v_row, cos_v_row, k_u, k_v, h_u_row, h_v_row, start, stop) {
  const h_u = 0;
  for (let i = start; i < stop; i++) {
    const cos_v = cos_v_row[i];
    const h_v = 2 * Math.PI * cos_v * k_v;
    h_u_row[i] = h_u;
    h_v_row[i] = h_v;
  }
}

function wave_numbers_rings(k_u, k_v) {
  const a = 0,
    b = 2 * k_v;
  return [a, b];
}

const fields = {
  sine: {
    height: height_sine_row,
    gradient: gradient_sine_row,
    kink: kink_sine_row,
    straddling: straddling_sine_row,
    forward: forward_sine_row,
    central: central_sine_row,
    central4: central4_sine_row,
    gradient_from_factors: gradient_from_factors_sine_row,
    wave_numbers: wave_numbers_sine,
    creases: [],
  },
  ridges: {
    height: height_ridges_row,
    gradient: gradient_ridges_row,
    kink: kink_ridges_row,
    straddling: straddling_ridges_row,
    forward: forward_ridges_row,
    central: central_ridges_row,
    central4: central4_ridges_row,
    gradient_from_factors: gradient_from_factors_ridges_row,
    wave_numbers: wave_numbers_ridges,
    creases: [["u", (k_u, k_v) => k_u], ["v", (k_u, k_v) => k_v]],
  },
  rings: {
    height: height_rings_row,
    gradient: gradient_rings_row,
    kink: kink_rings_row,
    straddling: straddling_rings_row,
    forward: forward_rings_row,
    central: central_rings_row,
    central4: central4_rings_row,
    gradient_from_factors: gradient_from_factors_rings_row,
    wave_numbers: wave_numbers_rings,
    creases: [],
  },
};

const max_algebraic = 64;
const scene = {"radius": 1.0, "eye": 4.0, "ball": true, "ball_center": [0.5, 0.5, 1.3], "ball_radius": 0.32, "floor": true, "lights": [{"position": [5.0, 5.0, 10.0], "color": [1.0, 1.0, 1.0]}, {"position": [-6.0, 2.0, 8.0], "color": [0.9, 0.65, 0.25]}], "ambient": [0.15, 0.15, 0.16], "albedo_a": [0.63, 0.19, 0.16], "albedo_b": [0.33, 0.44, 0.62], "ka": 0.1, "kd": 0.7, "ks": 0.5, "shininess": 32.0, "model": "blinn", "floor_tint": 0.25, "field": "ridges", "ku": 8.0, "kv": 4.0, "beta": 0.35};
const inferno = "00000300000400000601000701010901010b02010e02021003021204031404031605041806041b07051d08061f0906210a07230b07260d08280e082a0f092d10092f120a32130a34140b36160b39170b3b190b3e1a0b401c0c431d0c451f0c47200c4a220b4c240b4e260b50270b52290b542b0a562d0a582e0a5a300a5c32095d34095f3509603709613909623b09643c09653e0966400966410967430a68450a69460a69480b6a4a0b6a4b0c6b4d0c6b4f0d6c500d6c520e6c530e6d550f6d570f6d58106d5a116d5b116e5d126e5f126e60136e62146e63146e65156e66156e68166e6a176e6b176e6d186e6e186e70196e72196d731a6d751b6d761b6d781c6d7a1c6d7b1d6c7d1d6c7e1e6c801f6b811f6b83206b85206a86216a88216a8922698b22698d23698e24689024689125679325679526669626669827659928649b28649c29639e2963a02a62a12b61a32b61a42c60a62c5fa72d5fa92e5eab2e5dac2f5cae305baf315bb1315ab23259b43358b53357b73456b83556ba3655bb3754bd3753be3852bf3951c13a50c23b4fc43c4ec53d4dc73e4cc83e4bc93f4acb4049cc4148cd4247cf4446d04544d14643d24742d44841d54940d64a3fd74b3ed94d3dda4e3bdb4f3adc5039dd5238de5337df5436e05634e25733e35832e45a31e55b30e65c2ee65e2de75f2ce8612be9622aea6428eb6527ec6726ed6825ed6a23ee6c22ef6d21f06f1ff0701ef1721df2741cf2751af37719f37918f47a16f57c15f57e14f68012f68111f78310f7850ef8870df8880cf88a0bf98c09f98e08f99008fa9107fa9306fa9506fa9706fb9906fb9b06fb9d06fb9e07fba007fba208fba40afba60bfba80dfbaa0efbac10fbae12fbb014fbb116fbb318fbb51afbb71cfbb91efabb21fabd23fabf25fac128f9c32af9c52cf9c72ff8c931f8cb34f8cd37f7cf3af7d13cf6d33ff6d542f5d745f5d948f4db4bf4dc4ff3de52f3e056f3e259f2e45df2e660f1e864f1e968f1eb6cf1ed70f1ee74f1f079f1f27df2f381f2f485f3f689f4f78df5f891f6fa95f7fb99f9fc9dfafda0fcfea4";

return {
  fields,
  scene,
  inferno,
  max_algebraic,
  rint,
  image_extent,
  image_x,
  image_y,
  ambient_term,
  floor_albedo,
  parallel_radius,
  truncation_bound,
  clamped_bound,
  rounding_bound,
  crease_bound,
  slope_bound,
  sinpi_of_product_row,
  cospi_of_product_row,
  atan2pi_row,
  visible_surface_row,
  shadow_on_a_row,
  shadow_on_b_row,
  shadow_on_floor_row,
  checker_row,
  angles_on_a_row,
  chart_row,
  normal_on_a_row,
  normal_of_b_row,
  view_length_row,
  complex_square_row,
  complex_product_row,
  square_row,
  multiply_row,
  phong_row,
  phong_on_floor_row,
  blinn_squared_row,
  blinn_squared_on_floor_row,
  light_cosine_row,
  light_term_row,
  clip_row,
  slope_row,
  phong_of_1_on_a_row,
  phong_of_2_on_a_row,
  squared_of_1_on_a_row,
  squared_of_2_on_a_row,
  light_terms_of_1_on_sphere_row,
  light_terms_of_2_on_sphere_row,
};
};
