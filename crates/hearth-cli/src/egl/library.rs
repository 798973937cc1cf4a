//! The system's library EGL, and the devices that it lists.

use std::ffi::c_void;
use std::mem::transmute;
use std::ptr::null_mut;
use std::sync::OnceLock;

use khronos_egl::{self as egl, Boolean, Int};

use super::error::OffscreenError;

/// The functions of EGL 1.5.
pub type Egl = egl::DynamicInstance<egl::EGL1_5>;

/// A device of EGL_EXT_device_base.
pub type Device = *mut c_void;

/// Most devices that are asked for.
const MAX_DEVICES: usize = 64;

/// Number of devices that EGL lists: graphics cards, and Mesa's software renderer.
///
/// # Errors
/// EGL does not load.
pub fn device_count() -> Result<usize, OffscreenError> {
    library().map(|egl| devices(egl).len())
}

/// EGL, which stays loaded: drivers keep threads.
pub fn library() -> Result<&'static Egl, OffscreenError> {
    static EGL: OnceLock<Result<Egl, OffscreenError>> = OnceLock::new();
    let loaded = EGL.get_or_init(|| {
        // SAFETY: this is the system's library of that name.
        let loaded = unsafe { Egl::load_required() };
        loaded.map_err(|error| OffscreenError::NoEgl(error.to_string()))
    });
    loaded.as_ref().map_err(Clone::clone)
}

/// The devices of EGL_EXT_device_enumeration.
pub fn devices(egl: &Egl) -> Vec<Device> {
    type QueryDevices = unsafe extern "system" fn(Int, *mut Device, *mut Int) -> Boolean;
    let extensions = egl.query_string(None, egl::EXTENSIONS);
    let extensions = extensions.map(|names| names.to_string_lossy());
    let enumerates = extensions.is_ok_and(|names| {
        has(&names, "EGL_EXT_platform_device")
            && (has(&names, "EGL_EXT_device_enumeration") || has(&names, "EGL_EXT_device_base"))
    });
    let Some(query) = egl
        .get_proc_address("eglQueryDevicesEXT")
        .filter(|_| enumerates)
    else {
        return Vec::new();
    };
    let (mut devices, mut count) = (vec![null_mut(); MAX_DEVICES], 0);
    // SAFETY: the extension defines this signature, and the call writes at most `MAX_DEVICES` devices.
    let listed = unsafe {
        let query = transmute::<extern "system" fn(), QueryDevices>(query);
        query(MAX_DEVICES as Int, devices.as_mut_ptr(), &mut count)
    };
    let count = if listed == egl::TRUE { count.max(0) } else { 0 };
    devices.truncate(count as usize);
    devices
}

/// Whether a list of extensions names one.
pub fn has(extensions: &str, name: &str) -> bool {
    extensions.split(' ').any(|listed| listed == name)
}
