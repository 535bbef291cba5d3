//! Products of the poles of one form with themselves: polynomials of twice its degrees.

use pforms_kernel::{Form, Result, limit, pascal_row};

/// Where the products of Bernstein polynomials of given orders go, and with what weight.
///
/// `B_i·B_j = C(n,i)·C(n,j) / C(2n,i+j) · B_{i+j}` along every axis: with poles scaled by
/// their binomials a product is a convolution (Farouki and Rajan 1988).
pub(super) struct Products {
    /// Orders of the products: `2n − 1`.
    pub orders: Vec<usize>,
    places: Vec<usize>,
    binomials: Vec<f64>,
    inverse: Vec<f64>,
}

impl Products {
    /// Errors: `Limit` for products above the cap, `Accuracy` where binomials overflow.
    pub(super) fn new(form: &Form) -> Result<Self> {
        let orders: Vec<usize> = form.orders().iter().map(|order| 2 * order - 1).collect();
        let count = limit::check::<f64>("the square of the form", &orders, 1)?;
        form.orders().iter().try_for_each(|order| limit::check_degree::<f64>(2 * (order - 1)))?;
        let mut products = Self {
            places: vec![0],
            binomials: vec![1.0],
            inverse: vec![1.0; 1],
            orders: orders.clone(),
        };
        let mut stride = count;
        for (&order, &twice) in form.orders().iter().zip(&orders) {
            stride /= twice;
            let row = pascal_row::<f64>(order - 1);
            products.places = outer(&products.places, order, |place, i| place + i * stride);
            products.binomials = outer(&products.binomials, order, |b, i| b * row[i]);
            let row = pascal_row::<f64>(twice - 1);
            products.inverse = outer(&products.inverse, twice, |b, i| b / row[i]);
        }
        Ok(products)
    }

    /// Number of coefficients of a product.
    pub(super) fn count(&self) -> usize {
        self.inverse.len()
    }

    /// The Bernstein coefficients of `Σ product(i, j)·B_i·B_j`, for a symmetric `product`.
    pub(super) fn sum(&self, product: impl Fn(usize, usize) -> f64, sums: &mut Vec<f64>) {
        sums.clear();
        sums.resize(self.count(), 0.0);
        for (i, (place, binomial)) in self.places.iter().zip(&self.binomials).enumerate() {
            sums[2 * place] += binomial * binomial * product(i, i);
            for j in i + 1..self.places.len() {
                let factor = 2.0 * binomial * self.binomials[j];
                sums[place + self.places[j]] += factor * product(i, j);
            }
        }
        sums.iter_mut().zip(&self.inverse).for_each(|(sum, inverse)| *sum *= inverse);
    }
}

/// `combine(entry, i)` for every entry and every `i` below `count`, the last fastest.
fn outer<T: Copy>(entries: &[T], count: usize, combine: impl Fn(T, usize) -> T) -> Vec<T> {
    let combine = &combine;
    entries.iter().flat_map(|entry| (0..count).map(move |i| combine(*entry, i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_square_of_a_surface_is_its_square() {
        let heights = [1.0, 2.0, -1.0, 3.0, 0.5, 4.0];
        let form: Form = Form::from_points(&[2, 3], 1, &heights, None).unwrap();
        let products = Products::new(&form).unwrap();
        let mut square = Vec::new();
        products.sum(|i, j| heights[i] * heights[j], &mut square);
        let square: Form = Form::from_points(&products.orders, 1, &square, None).unwrap();
        for at in [[0.0, 0.0], [0.25, 0.75], [1.0, 0.5]] {
            let expected = form.at(&at).unwrap()[0].powi(2);
            assert!((square.at(&at).unwrap()[0] - expected).abs() < 1e-14);
        }
    }
}
