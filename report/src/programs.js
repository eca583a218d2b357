// The programs of the graphics processor.

const common = `#version 300 es
precision highp float;
precision highp int;
`;

// Triangles, three vertices each. `middle` is that of the simplex, towards which it is shrunk; `tone` a place on the scale
// of colours, below 0 for grey; `kind` one of the states of a simplex.
const triangleVertex = `${common}
uniform mat4 place, projection;
uniform vec3 offset;
uniform float shrink;
in vec3 point, middle;
in float shade;
in uvec2 number;
out vec3 edge, seen;
out float tone;
flat out uint kind;
flat out uint simplex;
void main() {
  int corner = gl_VertexID % 3;
  edge = vec3(corner == 0, corner == 1, corner == 2);
  seen = (place * vec4(mix(middle, point, shrink) + offset, 1.0)).xyz;
  tone = shade;
  simplex = number.x;
  kind = number.y;
  gl_Position = projection * vec4(seen, 1.0);
}`;

const triangleFragment = `${common}
uniform sampler2D tones;
uniform int picking, lit;
in vec3 edge, seen;
in float tone;
flat in uint kind;
flat in uint simplex;
out vec4 colour;
void main() {
  if (picking == 1) {
    uint number = simplex + 1u;
    colour = vec4(number & 255u, (number >> 8) & 255u, (number >> 16) & 255u, number >> 24) / 255.0;
    return;
  }
  vec3 base = tone < 0.0 ? vec3(0.72) : texture(tones, vec2((tone * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  if (kind == 3u) base = mix(base, vec3(0.93), 0.8);
  vec3 normal = cross(dFdx(seen), dFdy(seen));
  float light = lit == 1 ? 0.6 + 0.4 * abs(normal.z) / max(length(normal), 1e-20) : 1.0;
  vec3 width = fwidth(edge);
  vec3 near = edge / max(width, vec3(1e-6));
  float line = 1.0 - smoothstep(0.4, 1.3, min(near.x, min(near.y, near.z)));
  float strength = kind == 2u ? 1.0 : clamp(1.0 - 4.0 * max(width.x, max(width.y, width.z)), 0.0, 1.0) * (kind == 3u ? 0.15 : 0.55);
  vec3 ink = kind == 2u ? vec3(0.80, 0.02, 0.10) : vec3(0.05, 0.08, 0.12);
  colour = vec4(mix(base * light, ink, line * strength), 1.0);
}`;

// Segments as rectangles of `width` pixels to each side, six vertices each: both ends with every vertex.
const lineVertex = `${common}
uniform mat4 place, projection;
uniform vec2 size;
in vec3 from, to;
in vec4 tint;
in float width;
out vec4 ink;
void main() {
  vec4 a = projection * (place * vec4(from, 1.0)), b = projection * (place * vec4(to, 1.0));
  vec2 way = (b.xy / b.w - a.xy / a.w) * size;
  vec2 across = length(way) < 1e-6 ? vec2(1.0, 0.0) : normalize(vec2(-way.y, way.x));
  int corner = gl_VertexID % 6;
  vec4 end = corner == 0 || corner == 1 || corner == 3 ? a : b;
  end.xy += across * (corner == 0 || corner == 2 || corner == 4 ? width : -width) / size * end.w;
  end.z -= 0.0005 * end.w;
  ink = tint;
  gl_Position = end;
}`;

const lineFragment = `${common}
in vec4 ink;
out vec4 colour;
void main() { colour = ink; }`;

function compiled(gl, kind, text) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "a shader was not compiled");
  return shader;
}

/** A program with the places of its uniforms and attributes by their names. */
function linked(gl, vertex, fragment) {
  const program = gl.createProgram();
  gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertex));
  gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, fragment));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "a program was not linked");
  const uniforms = {}, attributes = {};
  for (let at = 0; at < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++at) {
    const { name } = gl.getActiveUniform(program, at);
    uniforms[name] = gl.getUniformLocation(program, name);
  }
  for (let at = 0; at < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); ++at) {
    const { name } = gl.getActiveAttrib(program, at);
    attributes[name] = gl.getAttribLocation(program, name);
  }
  return { program, uniforms, attributes };
}

export const triangleProgram = (gl) => linked(gl, triangleVertex, triangleFragment);
export const lineProgram = (gl) => linked(gl, lineVertex, lineFragment);
