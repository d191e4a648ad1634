// The Hamburger moment problem: of a distribution on -1..1, known by its power moments alone, how much lies before a place.
// Peters, Klein, Moment Shadow Mapping, I3D 2015; Muenstermann, Krumpen, Klein, Peters, Moment-Based Order-Independent
// Transparency, I3D 2018. There is one distribution of m + 1 points with the same 2 m moments and a point at z; the
// points before z hold the least that any can have there. Points x are found as t = 1 / (x - z), whose polynomial
// never degenerates; each one's share is 1 / sum of the squared orthonormal polynomials at x, which is never negative.

const int moments_most = 4;

// Moments 1 to 8 of an even spread, which the others are drawn to: for 4, 6 and 8 of them.
const vec4 moments_even_low[3] = vec4[3](vec4(0, 0.375, 0, 0.375), vec4(0, 0.48, 0, 0.451), vec4(0, 0.75, 0, 0.67666666));
const vec4 moments_even_high[3] = vec4[3](vec4(0), vec4(0, 0.45, 0, 0), vec4(0, 0.63, 0, 0.60030303));

// The real roots of x^2 + a.x x + a.y; where there are none by rounding, their real part.
vec2 quadratic_roots(vec2 a) {
  float q = -0.5 * (a.x + (a.x < 0.0 ? -1.0 : 1.0) * sqrt(max(a.x * a.x - 4.0 * a.y, 0.0)));
  return vec2(q, q != 0.0 ? a.y / q : 0.0);
}

// The three real roots of x^3 + a.x x^2 + a.y x + a.z.
vec3 cubic_roots(vec3 a) {
  float q = max((a.x * a.x - 3.0 * a.y) / 9.0, 0.0);
  float r = (2.0 * a.x * a.x * a.x - 9.0 * a.x * a.y + 27.0 * a.z) / 54.0;
  float angle = acos(clamp(r / max(q * sqrt(q), 1e-30), -1.0, 1.0)) / 3.0;
  return -2.0 * sqrt(q) * cos(angle + vec3(0.0, 2.0943951, -2.0943951)) - a.x / 3.0;
}

// The four real roots of x^4 + a.x x^3 + a.y x^2 + a.z x + a.w, as those of two quadratics (Ferrari).
vec4 quartic_roots(vec4 a) {
  float shift = 0.25 * a.x, square = shift * shift;
  float p = a.y - 6.0 * square;
  float q = a.z - 2.0 * a.y * shift + 8.0 * square * shift;
  float r = a.w - a.z * shift + a.y * square - 3.0 * square * square;
  vec3 resolvent = cubic_roots(vec3(2.0 * p, p * p - 4.0 * r, -q * q));
  float middle = max(max(resolvent.x, max(resolvent.y, resolvent.z)), 1e-20), slope = sqrt(middle);
  return vec4(quadratic_roots(vec2(slope, 0.5 * (p + middle - q / slope))), quadratic_roots(vec2(-slope, 0.5 * (p + middle + q / slope)))) - shift;
}

// The share of a distribution with the moments 1 to 2 m that lies before z, 0..1; `overestimation` of the point at z counts.
// m is 2, 3 or 4, known to the compiler.
float absorbed_before(int m, vec4 low, vec4 high, float z, float bias, float overestimation) {
  low = mix(low, moments_even_low[m - 2], bias);
  high = mix(high, moments_even_high[m - 2], bias);
  float b[2 * moments_most + 1] = float[](1.0, low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w);

  // The Hankel matrix of the moments is L D L^T: rows of L^-1 are the orthogonal polynomials, D their squared lengths.
  float l[moments_most + 1][moments_most + 1];
  float d[moments_most + 1];
  for (int j = 0; j <= m; ++j) {
    d[j] = b[2 * j];
    for (int k = 0; k < j; ++k) d[j] -= l[j][k] * l[j][k] * d[k];
    d[j] = max(d[j], 1e-9);
    for (int i = j + 1; i <= m; ++i) {
      l[i][j] = b[i + j];
      for (int k = 0; k < j; ++k) l[i][j] -= l[i][k] * l[j][k] * d[k];
      l[i][j] /= d[j];
    }
  }

  // Coefficients of the polynomial that is zero at the other points: Hankel^-1 (1, z, z^2 ...).
  float c[moments_most + 1];
  c[0] = 1.0;
  for (int i = 1; i <= m; ++i) c[i] = c[i - 1] * z;
  for (int i = 1; i <= m; ++i)
    for (int k = 0; k < i; ++k) c[i] -= l[i][k] * c[k];
  float own = 0.0;
  for (int i = 0; i <= m; ++i) {
    own += c[i] * c[i] / d[i];
    c[i] /= d[i];
  }
  for (int i = m - 1; i >= 0; --i)
    for (int k = i + 1; k <= m; ++k) c[i] -= l[k][i] * c[k];
  // Shifted to z and reversed, as t wants it; divided by its leading coefficient, which is 1 / the share of z.
  for (int i = 0; i < m; ++i)
    for (int k = m - 1; k >= i; --k) c[k] += z * c[k + 1];
  for (int i = 1; i <= m; ++i) c[i] /= own;

  vec4 t = vec4(0);
  if (m == 2) t.xy = quadratic_roots(vec2(c[1], c[2]));
  if (m == 3) t.xyz = cubic_roots(vec3(c[1], c[2], c[3]));
  if (m == 4) t = quartic_roots(vec4(c[1], c[2], c[3], c[4]));

  float before = overestimation / own, all = 1.0 / own;
  for (int i = 0; i < m; ++i) {
    float x = z + 1.0 / (abs(t[i]) < 1e-6 ? 1e-6 : t[i]);
    float y[moments_most + 1];
    float squares = 1.0, power = 1.0;
    y[0] = 1.0;
    for (int j = 1; j <= m; ++j) {
      power *= x;
      y[j] = power;
      for (int k = 0; k < j; ++k) y[j] -= l[j][k] * y[k];
      squares += y[j] * y[j] / d[j];
    }
    float share = 1.0 / squares;
    all += share;
    if (t[i] < 0.0) before += share;
  }
  return clamp(before / all, 0.0, 1.0);
}
