//! Nothing that is typed is passed over in silence: in every context, each option, each key of a scene or behind the name of a
//! file, and each column of a table changes what comes out, is named as without effect, or is refused by name.

mod columns;
mod file_keys;
mod options;
mod scene_keys;
mod walk;
