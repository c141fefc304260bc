/** Lets timers and messages have their turn, a cancellation among them: promises alone do not. */
export function nextTurn(): Promise<void> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.onmessage = () => {
      // An open port keeps a process alive.
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
