import assert from "node:assert/strict";
import { test } from "node:test";
import { joinCurves, onlyForward, SeriesTable, valueAt } from "../../../web/src/series_table.ts";

const columns = ["time", "cell0.x", "cell0.tau", "cell1.x", "cell1.tau", "inflow"];

test("rows that arrive later go on where the first ones ended", () => {
  const table = new SeriesTable();
  table.append({ columns, units: {}, rows: [[0, 1, 2, 3, 4, 5]] });
  table.append({ columns, units: {}, rows: [] });
  table.append({
    columns,
    units: {},
    rows: [
      [1, 1.5, 2.5, 3.5, null, 5],
      [2, 2, 3, 4, 5, 5],
    ],
  });
  assert.equal(table.rows, 3);
  assert.equal(table.cells, 2);
  assert.deepEqual(table.column("cell0.x"), [1, 1.5, 2]);
  assert.deepEqual(table.column("cell1.tau"), [4, null, 5]);
  assert.deepEqual(table.column("nothing"), []);
  table.clear();
  assert.equal(table.rows, 0);
  assert.equal(table.cells, 0);
});

test("a curve over position leaves out where the cell was pushed back", () => {
  assert.deepEqual(onlyForward([1, 2, 1.5, 1.9, 2.5, null], [10, 20, 30, 40, 50, 60]), [
    [1, 2, 2.5],
    [10, 20, 50],
  ]);
});

test("curves of two cells share one ascending abscissa, each linear between its own points", () => {
  assert.deepEqual(
    joinCurves([
      [
        [1, 3],
        [10, 30],
      ],
      [
        [2, 3, 4],
        [20, null, 40],
      ],
    ]),
    [
      [1, 2, 3, 4],
      [10, 20, 30, null],
      [null, 20, null, 40],
    ],
  );
});

test("values between the rows are linear, and none beyond them", () => {
  assert.equal(valueAt([0, 1, 2], [5, 7, 11], 1.5), 9);
  assert.equal(valueAt([0, 1, 2], [5, 7, 11], 0), 5);
  assert.equal(valueAt([0, 1, 2], [5, 7, 11], 2.5), undefined);
  assert.equal(valueAt([0, 1, 2], [5, null, 11], 0.5), undefined);
  assert.equal(valueAt([], [], 0), undefined);
});
