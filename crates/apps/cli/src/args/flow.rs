//! Arguments of `flow`.

use clap::Args as ClapArgs;
use measurements::ScanRequest;
use questions::flow::FlowEdges;

use super::parsers::one_of;
use super::scans::FileDefaults;
use crate::picture::Picture;

/// A gap, the conditions at its edges, and a picture.
#[derive(Debug, ClapArgs)]
pub(crate) struct FlowArgs {
    /// A map of gaps, perhaps with options of its own (FILE:unit=nm,size=1um): a field of `bem --fields`, or any file of heights, which
    /// are taken for gaps. Points without a gap above 0 are contact
    #[arg(value_name = "GAP")]
    pub gap: ScanRequest,
    /// Edges of the gap: periodic, it repeats itself in both directions (where not given); reservoirs, one feeds a whole edge and one
    /// drains the opposite edge, and the gap repeats itself at its sides; channel, likewise with walls at its sides
    #[arg(long, value_name = "KIND", value_parser = one_of::<FlowEdges, _>(FlowEdges::ALL))]
    pub edges: Option<FlowEdges>,
    #[command(flatten)]
    pub defaults: FileDefaults,
    /// Draw the flow along x, and into FILE-y along y: its logarithm in colours, contact grey, white where nothing flows
    #[arg(long, value_name = "FILE.svg|FILE.png")]
    pub figure: Option<Picture>,
}
