//! `moments`, `amplitude` and `fit`: what a spectrum alone tells.

use questions::{SpectrumQuantity, SpectrumQuestion};

use super::{Context, Figure};
use crate::args::{AmplitudeArgs, FitArgs, MomentsArgs, PsdArgs, SamplingArgs};
use crate::failure::Failure;

pub(super) fn moments(args: &MomentsArgs, context: &Context<'_>) -> Result<(), Failure> {
    let normalisation = args.normalisation.normalisation.unwrap_or_default();
    let quantity = SpectrumQuantity::Moments { normalisation };
    answer(quantity, &args.psd, &args.sampling, args.figure.figure.as_ref(), context)
}

pub(super) fn amplitude(args: &AmplitudeArgs, context: &Context<'_>) -> Result<(), Failure> {
    let definition = args.amplitude.amplitude.unwrap_or_default();
    let quantity = SpectrumQuantity::Amplitude { definition };
    answer(quantity, &args.psd, &args.sampling, args.figure.figure.as_ref(), context)
}

pub(super) fn fit(args: &FitArgs, context: &Context<'_>) -> Result<(), Failure> {
    let (from_m, to_m) = (args.from.map(|end| end.m), args.to.map(|end| end.m));
    answer(SpectrumQuantity::Fit { from_m, to_m }, &args.psd, &args.sampling, None, context)
}

fn answer(
    quantity: SpectrumQuantity,
    psd: &PsdArgs,
    sampling: &SamplingArgs,
    figure: Figure<'_>,
    context: &Context<'_>,
) -> Result<(), Failure> {
    let question = SpectrumQuestion { quantity, sampling: sampling.input(), figure: figure.is_some() };
    let steps = |_: &_| Ok(SpectrumQuestion::STEPS);
    context.answer(psd, &question.sampling, figure, steps, |surface, progress| {
        question.answer(surface, progress)
    })
}
