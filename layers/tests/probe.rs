//! Scratch.
use recede_layers::*;
use nalgebra::*;
fn both(s:&FaceStates)->[f64;4]{ let FaceStates::Finite{top,bottom,..}=s else {panic!()};
  let rows = Matrix4::from_rows(&[top.row(2), top.row(3), bottom.row(2), bottom.row(3)]);
  let a = solve_equilibrated(rows, Matrix4x2::new(1.,0.,0.,0.,0.,1.,0.,0.)).unwrap();
  let t=top.row(1)*a; let b=bottom.row(1)*a; [t[0],t[1],-b[0],b[1]] }
#[test]
fn probe(){
  let layer = Exponential::new(1.0,1.0,0.25,-30.0).unwrap();
  for lam in [1e-6,1e-3,0.01,0.1,0.3,0.5,0.9,1.1,1.2,1.3,1.5,2.0,4.0,10.0] { let w=Wave{wavenumber:lam,modulus:1.0,plane:Plane::Strain};
   let x=layer.flexibility(&w).unwrap();
   let r=[x.top,x.coupling,x.coupling,x.bottom];
   let e=both(&layer.face_states(&w)); let g=both(&graded::face_states(&layer,&w));
   println!("x {lam:6} {:10.3e} {:10.3e} {:10.3e} | {} | {}", x.top,x.coupling,x.bottom, (0..4).map(|i|format!("{:.0e}",e[i]/r[i]-1.)).collect::<Vec<_>>().join(" "), (0..4).map(|i|format!("{:.0e}",g[i]/r[i]-1.)).collect::<Vec<_>>().join(" "));
  }
}
#[test]
fn digits(){ let layer = Exponential::new(1.0,1.0,0.25,-30.0).unwrap();
 for lam in [0.3,0.5,0.9,1.1] { let w=Wave{wavenumber:lam,modulus:1.0,plane:Plane::Strain}; println!("# {lam} {:?} of_face_states: {:?}", layer.flexibility(&w).unwrap(), both(&layer.face_states(&w))); } }
#[test]
fn dump(){ use std::fmt::Write; let mut s=String::new();
 for (nu,b) in [(0.5,30.0),(0.5,-30.0),(0.0,30.0),(0.0,-30.0),(0.25,-30.0),(0.25,8.0),(0.25,-8.0),(-0.9,30.0),(-0.9,-30.0)] { let layer = Exponential::new(1.0,1.0,nu,b).unwrap();
 for lam in [1e-4,1e-2,0.03,0.05,0.1,0.2,0.5,0.9,1.5,3.0,10.0,60.0] { let w=Wave{wavenumber:lam,modulus:1.0,plane:Plane::Strain};
  let x=layer.flexibility(&w).unwrap(); let y=Flexibility::of_face_states(&graded::face_states(&layer,&w)).unwrap();
  writeln!(s,"{lam:?} {nu:?} {b:?} {}",[x.top,x.coupling,x.bottom,x.equal_top,x.equal_bottom,y.top,y.coupling,y.bottom,y.equal_top,y.equal_bottom].map(|x|format!("{x:?}")).join(" ")).unwrap(); }}
 std::fs::write("/tmp/h3_vals.txt",s).unwrap(); }
