// What the programs of the other queues share: clients that each wait for their own answer before the next call.

export const [folder, jobs, clients, bytes] = [process.argv[2], ...process.argv.slice(3).map(Number)];

const percentile = (sorted, share) => sorted[Math.round(share * (sorted.length - 1))];

export function payload(k) {
  const mark = `${k}-`;
  return { version: 1, name: mark + "x".repeat(bytes - mark.length - '{"version":1,"name":""}'.length) };
}

export function report(measure, seconds, took) {
  took.sort((a, b) => a - b);
  const [p50, p99] = [0.5, 0.99].map((share) => (took.length ? Number(percentile(took, share).toFixed(3)) : null));
  console.log(JSON.stringify({ measure, jobs, rate: Number((jobs / seconds).toFixed(1)), p50_ms: p50, p99_ms: p99 }));
}

export async function measure(name, one) {
  let next = 0;
  const took = [];
  const client = async (index) => {
    for (let k = next++; k < jobs; k = next++) {
      const asked = performance.now();
      await one(k, index);
      took.push(performance.now() - asked);
    }
  };
  const begun = performance.now();
  await Promise.all(Array.from({ length: clients }, (_, index) => client(index)));
  report(name, (performance.now() - begun) / 1000, took);
}
