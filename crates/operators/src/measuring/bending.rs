//! Second fundamental forms as polynomials.

use pforms_kernel::{Form, Result, Scalar, Scaled};

/// `W²·N·f_kl` for vectors `N` across the form: `W·(N·X_kl) − (N·X)·W_kl`.
pub(crate) fn bending<S: Scalar>(
    form: &Form<S>,
    normal: &Form<S>,
    k: usize,
    l: usize,
) -> Result<Scaled<S>> {
    let all = Scaled::from_form(form);
    let normal = Scaled::from_form(normal);
    let bend = all.derivative(k).derivative(l);
    if let Some(weight) = form.uniform_weight() {
        let weight = Scaled::constant(form.axes(), std::slice::from_ref(weight));
        return dot_product(&normal, &bend)?.times(&weight);
    }
    let ambient = form.ambient();
    let bent = dot_product(&normal, &bend)?.times(&all.component(ambient))?;
    let carried = dot_product(&normal, &all)?.times(&bend.component(ambient))?;
    difference(&bent, &carried)
}

/// The sum of the products of all components but the last, the weight.
pub(crate) fn dot_product<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>) -> Result<Scaled<S>> {
    let mut sum = a.component(0).times(&b.component(0))?;
    for k in 1..a.width() - 1 {
        sum.add_product(&a.component(k), &b.component(k));
    }
    Ok(sum)
}

/// `a − b`, of whatever degrees.
pub(crate) fn difference<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>) -> Result<Scaled<S>> {
    let degrees: Vec<usize> = a.degrees().iter().zip(b.degrees()).map(|(a, b)| *a.max(b)).collect();
    Ok(a.raised_to(&degrees)?.minus(&b.raised_to(&degrees)?))
}
