//! stat-contact
