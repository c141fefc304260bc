//! `FILE LENGTH`: the crate's gift opening of raw float32 points, timed; prints what hull-child.ts prints.
use concave_hull::f64::{Point, concave_hull};
use std::time::Instant;

const RUNS: usize = 15;
const ENOUGH_S: f64 = 3.0;

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&words[1]).expect("a file of points");
    let length: f64 = words[2].parse().expect("an edge length in metres");
    let number = |i: usize| f32::from_le_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap()) as f64;
    let points: Vec<Point> = (0..bytes.len() / 8)
        .map(|i| Point::new(number(2 * i), number(2 * i + 1)))
        .collect();
    let mut times: Vec<f64> = Vec::new();
    let mut ring = Vec::new();
    while times.len() < RUNS && times.iter().sum::<f64>() < ENOUGH_S {
        let start = Instant::now();
        ring = concave_hull(&points, length);
        times.push(start.elapsed().as_secs_f64());
    }
    let best = times.iter().copied().fold(f64::INFINITY, f64::min);
    let xy: Vec<String> = ring.iter().map(|(_, p)| format!("{},{}", p.x, p.y)).collect();
    println!(
        "{{\"firstMs\":{},\"ms\":{},\"peakMB\":{},\"ring\":[{}]}}",
        times[0] * 1000.0,
        best * 1000.0,
        peak_mb(),
        xy.join(",")
    );
}

/// Peak memory of the process as the kernel tells it; 0 where it does not.
fn peak_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().nth(1)?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) / 1024.0
}
