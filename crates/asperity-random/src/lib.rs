//! Asperities of a random surface: heights and radii spread together, under any law of one asperity.
//!
//! # Equations
//! The summits of an isotropic Gaussian surface have heights z above its mean plane, mean
//! curvatures k_m and Gaussian curvatures k² = 1/R² with the density (per area)
//! ```text
//! D(z, k_m, k) = 1/(2π m₂) N(k_m; 0, 2s) (k³/s) exp(-(k_m²-k²)/(2s)) N(z; μ k_m, σ_c²),   0 < k < k_m
//! s = m₄/3,   μ = 3 m₂/(2 m₄),   σ_c² = m₀ (1 - 3/(2α)),   α = m₀ m₄/m₂²
//! ```
//! A law of one asperity has no length but R: q(w; R) = R² f(w/R) for forces and areas. Its average
//! over k and k_m at a given u = w - μ k_m,
//! ```text
//! M(u) = ∫∫ q(u + μ k_m; 1/k) D dk dk_m
//! ```
//! is one law again, under heights that are Gaussian with the standard deviation σ_c: it is
//! tabulated when first needed, and a value costs then what one of GW costs. What does not depend
//! on the law is tabulated once in a process, so that the first law takes a second and each other
//! some hundredths.
//!
//! # Valid for
//! Upright asperities: models whose contact normals are spread over angles are refused. Heights
//! must be Gaussian, the bandwidth α above 1.5, and separations at most [`FARTHEST`] √m₀ from the
//! mean plane. Moments are those of
//! [`Surface::moments`](asperity_core::Surface::moments): what the surface was made of, where it
//! was made of moments.
//!
//! Broad surfaces do not come back to GW: for α → ∞ the summits are as high as the surface, whatever
//! their curvature, but radii stay spread, so that with the single radius 1/⟨k_m⟩ of GW areas are too
//! small by ⟨1/k⟩⟨k_m⟩ = 1.355 at a separation, forces by ⟨k^(-1/2)⟩⟨k_m⟩^(1/2) = 1.130, and areas at a
//! load by 1.20, the ratio of the two. \[derived; tested against the integrals\]
//!
//! # Source
//! Nayak 1971, "Random process model of rough surfaces", for the density \[derived\]; Greenwood
//! 2006, "A simplified elliptic model of rough surface contact", for Hertz' law under it.
//! \[recalled\]
//!
//! # Example
//! ```
//! use asperity_core::{ContactModel, Interface, ProfileMoments, Quantity, Request, Scene, Separation, Surface};
//! use asperity_gw::GreenwoodWilliamson;
//! use asperity_random::RandomAsperities;
//!
//! let surface = Surface::from_moments(&ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 8e4 })?;
//! let scene = Scene::new(Interface::elastic(116e9, 0.31), surface, 3e-5);
//! let far = Separation::metres(3e-6).from_surface_mean();
//! let asked = Request::new([Quantity::Area]).at([far]);
//! let one = GreenwoodWilliamson.solve(&scene, &asked)?.values(Quantity::Area)?[0];
//! let all = RandomAsperities::new(GreenwoodWilliamson).solve(&scene, &asked)?.values(Quantity::Area)?[0];
//! // High asperities are sharper than the mean, so that less of them touches.
//! assert!(all < one && all > 0.2 * one);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

mod average;
mod contact;
mod kernel;
mod population;
#[cfg(test)]
mod tests;

pub use contact::{FARTHEST, RandomAsperities, SUFFIX};
