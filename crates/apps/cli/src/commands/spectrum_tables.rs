//! `moments`, `amplitude` and `fit`: what a spectrum alone tells.

use questions::{SpectrumQuantity, SpectrumQuestion};

use super::Context;
use crate::args::{AmplitudeArgs, FitArgs, MomentsArgs};
use crate::failure::Failure;

pub(super) fn moments(args: &MomentsArgs, context: &Context<'_>) -> Result<(), Failure> {
    let normalisation = args.normalisation.normalisation.unwrap_or_default();
    let figure = args.figure.figure.as_ref();
    let question = SpectrumQuestion {
        quantity: SpectrumQuantity::Moments { normalisation },
        sampling: args.sampling.input(),
        figure: figure.is_some(),
    };
    context.spectrum(&question, &args.psd, figure)
}

pub(super) fn amplitude(args: &AmplitudeArgs, context: &Context<'_>) -> Result<(), Failure> {
    let definition = args.amplitude.amplitude.unwrap_or_default();
    let figure = args.figure.figure.as_ref();
    let question = SpectrumQuestion {
        quantity: SpectrumQuantity::Amplitude { definition },
        sampling: args.sampling.input(),
        figure: figure.is_some(),
    };
    context.spectrum(&question, &args.psd, figure)
}

pub(super) fn fit(args: &FitArgs, context: &Context<'_>) -> Result<(), Failure> {
    let (from_m, to_m) = (args.from.map(|end| end.m), args.to.map(|end| end.m));
    let question = SpectrumQuestion {
        quantity: SpectrumQuantity::Fit { from_m, to_m },
        sampling: args.sampling.input(),
        figure: false,
    };
    context.spectrum(&question, &args.psd, None)
}
