// Work in turns: in each lane one piece after another. Of the pieces of one kind that wait in a
// lane only the latest is done; a piece without a kind is always done.
export class Turns {
  constructor(changed = () => {}) {
    this.changed = changed;
    this.lanes = new Map();
  }

  // The promise of what the piece returns; of undefined where a later piece takes its place.
  add(lane, kind, piece) {
    if (!this.lanes.has(lane)) this.lanes.set(lane, { waiting: [], running: false });
    const { waiting } = this.lanes.get(lane);
    const older = waiting.findIndex((other) => kind !== null && other.kind === kind);
    if (older >= 0) waiting.splice(older, 1)[0].resolve(undefined);
    return new Promise((resolve, reject) => {
      waiting.push({ kind, piece, resolve, reject });
      this.changed();
      this.run(lane);
    });
  }

  // Whether any piece runs or waits.
  get busy() {
    return [...this.lanes.values()].some(({ waiting, running }) => running || waiting.length > 0);
  }

  async run(name) {
    const lane = this.lanes.get(name);
    if (lane.running) return;
    lane.running = true;
    while (lane.waiting.length > 0) {
      const { piece, resolve, reject } = lane.waiting.shift();
      try {
        resolve(await piece());
      } catch (error) {
        reject(error);
      }
    }
    lane.running = false;
    this.changed();
  }
}
