use super::*;

const SCREEN: (&str, &str) = (
    "screen.vert",
    "out vec2 uv;\nvoid main() {\n    uv = vec2(gl_VertexID);\n    gl_Position = vec4(uv, 0.0, 1.0);\n}\n",
);

const LIGHT: (&str, &str) = (
    "light.glsl",
    "uniform float gain; // brightness\nuniform float unused;\nvec3 lit(vec3 light) {\n    return light * gain;\n}\nfloat idle() {\n    return unused;\n}\n",
);

const PASS: &str = "#include \"light.glsl\"
in vec2 uv;
uniform sampler2D field; // what it reads
uniform vec2 size;       // in pictures
uniform vec3 tint;
out vec4 pixel;
const float HALF = 0.50; // half
void main() {
    vec2 place = uv * size.yx - -HALF;
    pixel = vec4(lit(texture(field, place).rgb + tint * WHOLE), 1.0);
}
";

fn compiled(pass: &str) -> Result<Program, String> {
    let files = Files::from([SCREEN, LIGHT, ("pass.frag", pass)]);
    let mut programs = programs(&files, &[("WHOLE", "1.0".to_owned())])?;
    assert_eq!(programs.len(), 1);
    Ok(programs.remove(0))
}

fn complaint(old: &str, new: &str) -> String {
    let broken = PASS.replace(old, new);
    assert_ne!(broken, PASS, "{old}");
    match compiled(&broken) {
        Ok(_) => format!("{old} → {new} compiles"),
        Err(message) => message,
    }
}

#[test]
fn includes_are_resolved_and_uniforms_packed() {
    let program = compiled(PASS).unwrap();
    assert_eq!(program.name, "pass");
    let uniforms = program.uniforms.iter();
    let packed: Vec<_> = uniforms.map(|u| (u.name.as_str(), u.size, u.at)).collect();
    assert_eq!(packed, [("gain", 1, 3), ("size", 2, 4), ("tint", 3, 0)]);
    assert_eq!(program.uniforms[0].comment, "brightness");
    assert_eq!(program.vectors, 2);
    assert_eq!(program.samplers, ["field"]);
    assert_eq!(
        program.stages[1].text(),
        "uniform vec4 U[2];\nvec3 lit(vec3 light){\nreturn light*U[0].w;\n}\nin vec2 uv;\n\
         uniform sampler2D field;\nout vec4 pixel;\nvoid main(){\nvec2 place=uv*U[1].yx- -.5;\n\
         pixel=vec4(lit(texture(field,place).rgb+U[0].xyz*1.),1.);\n}\n"
    );
}

#[test]
fn errors_name_the_file_and_the_problem() {
    for (old, new, message) in [
        ("* size.yx", "* sise.yx", "sise is used and not declared"),
        ("size.yx", "size.zx", "size.zx: size has 2 components"),
        (
            "tint * WHOLE",
            "gain.x * tint",
            "gain.x: gain has 1 components",
        ),
        ("vec3 tint", "mat3 tint", "a uniform cannot be a mat3"),
        (
            "vec3 tint",
            "vec4 tint[2]",
            "tint is an array without an index",
        ),
        ("vec3 tint", "vec4 tint[]", "tint has no length"),
        (
            "vec3 tint",
            "float gain; uniform vec3 tint",
            "gain is declared twice",
        ),
        (" + tint * WHOLE", "", "tint is declared and never used"),
        (
            "vec2 place",
            "vec2 size = uv; vec2 place",
            "size is global and a variable of main",
        ),
        ("light.glsl", "dark.glsl", "no shader file dark.glsl"),
        ("1.0);\n}", "1.0);\n", "ends in the middle of a declaration"),
        ("uv * size", "uv @ size", "'@' has no place in GLSL"),
    ] {
        let complaint = complaint(old, new);
        assert!(complaint.contains(message), "{complaint}");
        assert!(complaint.contains("pass.frag"), "{complaint}");
    }
}

#[test]
fn a_uniform_with_two_types_is_an_error() {
    let files = Files::from([
        (
            "pass.vert",
            "uniform vec2 size;\nvoid main() {\n    gl_Position = size.xyxy;\n}\n",
        ),
        (
            "pass.frag",
            "uniform vec3 size;\nout vec4 pixel;\nvoid main() {\n    pixel = size.xyzz;\n}\n",
        ),
    ]);
    let complaint = programs(&files, &[]).err().unwrap();
    assert!(complaint.contains("size is of two types"), "{complaint}");
}

#[test]
fn an_array_stands_before_the_vectors() {
    let program = compiled(
        &PASS
            .replace("vec3 tint", "vec4 tint[2]")
            .replace("tint * WHOLE", "tint[1].rgb"),
    )
    .unwrap();
    let uniforms = program.uniforms.iter();
    let packed: Vec<_> = uniforms.map(|u| (u.name.as_str(), u.size, u.at)).collect();
    assert_eq!(packed, [("gain", 1, 10), ("size", 2, 8), ("tint", 8, 0)]);
    let text = program.stages[1].text();
    assert!(text.contains("uniform vec4 U[3];"), "{text}");
    assert!(text.contains("U[0+1].rgb"), "{text}");
}

#[test]
fn no_uniform_spans_two_vectors_or_overlaps_another() {
    let folder = std::path::Path::new("shaders");
    let files = Files::read(folder).unwrap();
    for program in programs(&files, &crate::values::shared()).unwrap() {
        let mut taken = vec![false; 4 * program.vectors];
        for uniform in &program.uniforms {
            let last = uniform.at + uniform.size - 1;
            let spans = uniform.at / 4 != last / 4;
            let is_array = uniform.size > 4 && uniform.at % 4 == 0;
            assert!(!spans || is_array, "{}: {}", program.name, uniform.name);
            for component in &mut taken[uniform.at..=last] {
                assert!(!std::mem::replace(component, true), "{}", uniform.name);
            }
        }
    }
}
