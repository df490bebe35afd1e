/**
 * Campaign plans: which runs a study makes. A plan file names worlds, seeds, and everything that varies; each run's
 * scenario follows from the plan and the run's index alone, so that any process can make any part of a campaign. Knows
 * nothing of threads and output files; immutable once read, safe on any thread.
 */
package faultline.campaign.plan;
