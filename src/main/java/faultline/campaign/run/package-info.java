/**
 * Campaigns: makes the runs of a plan on several threads and writes one row per run, in the order of the plan. Rows are
 * forced to the disk during the campaign, so that it can be resumed after any interruption. Its table has the same
 * bytes for any division into parts. Simulations run on a pool of threads; all files are written by the calling thread.
 *
 * <p>The words, in order: a {@code PlannedRun} of a plan gives a scenario, which {@code RunMaker} runs to its
 * {@code RunResult}. The {@code Outcome} sums that up in a word. {@code ResultColumns} turns both into a row of
 * {@code runs.csv}, which a {@code MadeRun} carries to the {@code RunTable}. Reports read the rows as {@code RunRow}s.
 * {@code ReplayScenario} makes a run again from its plan.
 */
package faultline.campaign.run;
