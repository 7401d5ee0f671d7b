//! Materials: conversion, tables, fits.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod conversion_mpmath;
mod fit;
mod fit_rest_and_rows;
mod isotropic;
mod kramers_kronig;
mod tables_mutated;
