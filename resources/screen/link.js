// The connection to the robot: a WebSocket that comes back by itself.

const FIRST_WAIT = 200;
const LONGEST_WAIT = 2000;
const SILENCE = 6500; // three signs of life missed

// hear(state): what is to be shown. wait("robot" | "key" | null): why nothing comes, or that it does.
export function connect(hear, wait) {
  let socket = null;
  let delay = FIRST_WAIT;
  let watchdog = 0;

  const alive = () => {
    clearTimeout(watchdog);
    watchdog = setTimeout(() => socket?.close(), SILENCE);
  };

  const again = async () => {
    clearTimeout(watchdog);
    socket = null;
    wait("robot");
    // A key that is no longer right has to be said: waiting would be for nothing.
    try {
      const answer = await fetch("/", { cache: "no-store" });
      if (answer.status === 403) wait("key");
    } catch { /* nobody there yet */ }
    setTimeout(open, delay);
    delay = Math.min(delay * 1.6, LONGEST_WAIT);
  };

  const open = () => {
    socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`);
    socket.binaryType = "arraybuffer";
    const decoder = new TextDecoder();
    socket.onmessage = ({ data }) => {
      alive();
      const message = JSON.parse(typeof data === "string" ? data : decoder.decode(data));
      if (message.show) {
        delay = FIRST_WAIT;
        wait(null);
        hear(message.show);
      }
    };
    socket.onclose = again;
    alive();
  };

  open();
  return (message) => {
    if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
  };
}
