//! From and to the rotations and isometries of nalgebra.

use nalgebra::{
    Complex as NaComplex, Isometry2, Isometry3, Quaternion, Translation2, Translation3, UnitComplex, UnitQuaternion,
};

use crate::{Complex, SE2, SE3, SO2, SO3, Turn};

impl From<UnitComplex<f64>> for SO2<f64> {
    fn from(r: UnitComplex<f64>) -> Self {
        Turn::new(Complex::new(r.re, r.im), ()).into()
    }
}

impl From<SO2<f64>> for UnitComplex<f64> {
    fn from(r: SO2<f64>) -> Self {
        let unit = r.unit();
        Self::new_unchecked(NaComplex::new(unit.re, unit.im))
    }
}

impl From<Isometry2<f64>> for SE2<f64> {
    fn from(pose: Isometry2<f64>) -> Self {
        Self::new(pose.rotation.into(), &pose.translation.vector)
    }
}

impl From<SE2<f64>> for Isometry2<f64> {
    fn from(pose: SE2<f64>) -> Self {
        Self::from_parts(Translation2::from(pose.translation()), pose.rotation().into())
    }
}

impl From<UnitQuaternion<f64>> for SO3<f64> {
    fn from(r: UnitQuaternion<f64>) -> Self {
        Self::from_spin([r.w, r.i, r.j, r.k])
    }
}

impl From<SO3<f64>> for UnitQuaternion<f64> {
    fn from(r: SO3<f64>) -> Self {
        let [w, x, y, z] = r.quaternion();
        Self::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

impl From<Isometry3<f64>> for SE3<f64> {
    fn from(pose: Isometry3<f64>) -> Self {
        Self::new(pose.rotation.into(), [pose.translation.vector], [])
    }
}

impl From<SE3<f64>> for Isometry3<f64> {
    fn from(pose: SE3<f64>) -> Self {
        Self::from_parts(Translation3::from(pose.fixed()[0]), pose.frame().into())
    }
}
