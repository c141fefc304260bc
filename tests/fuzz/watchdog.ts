import { Worker } from 'node:worker_threads';

/**
 * Looks from another thread: a loop that never ends keeps its own thread from looking. Counts the processor's time, for
 * other programs may keep the case waiting; ten times as much on the clock is a wait that never ends.
 */
const CODE = `
const { workerData: { shared, limit, words } } = require('node:worker_threads');
const { writeSync } = require('node:fs');
const number = new Int32Array(shared);
const spent = () => { const { user, system } = process.cpuUsage(); return (user + system) / 1000; };
let last = -1, since = 0, sinceSpent = 0;
setInterval(() => {
  const now = Atomics.load(number, 0);
  if (now !== last || now < 0) { last = now; since = Date.now(); sinceSpent = spent(); }
  else if (spent() - sinceSpent > limit || Date.now() - since > 10 * limit) {
    writeSync(2, words + ' --case ' + now + ': no end after ' + limit + ' ms\\n');
    process.kill(process.pid, 'SIGKILL');
  }
}, 100);
`;

export interface Watchdog {
  /** Says which case begins. */
  begin(number: number): void;
  stop(): Promise<unknown>;
}

/** Ends the process when a case takes more than `limit` ms of work. @param words begin of what it then says */
export function startWatchdog(limit: number, words: string): Watchdog {
  const shared = new SharedArrayBuffer(4);
  const number = new Int32Array(shared).fill(-1);
  const worker = new Worker(CODE, { eval: true, workerData: { shared, limit, words } });
  return {
    begin: (now) => void Atomics.store(number, 0, now),
    stop: () => worker.terminate(),
  };
}
