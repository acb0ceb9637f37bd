// The functions of the core, as the build makes them from crates/apps/web/src/door.rs.
export default function init(from: { module_or_path: URL }): Promise<unknown>;
export function choices(): string;
export function look(file: string): string;
export function answer(request: string): string;
export function judge(request: string, draws: boolean): string;
export function report(request: string, date: string): string;
