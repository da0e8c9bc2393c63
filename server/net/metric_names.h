// The names that /metrics shows of the network face, in one place.
#pragma once
#include <string>
#include <string_view>

namespace cloudscape::net::metric {

constexpr auto connections = "cloudscape_connections";                      // TCP connections now
constexpr auto sessions = "cloudscape_sessions";                            // WebSockets now
constexpr auto messages_in = "cloudscape_stream_messages_received_total";   // client messages
constexpr auto message_errors = "cloudscape_stream_message_errors_total";   // answered by an error message
constexpr auto frames_sent = "cloudscape_stream_frames_sent_total";         // handed to a socket
constexpr auto frames_dropped = "cloudscape_stream_frames_replaced_total";  // by a newer one before the socket took it
constexpr auto stills_sent = "cloudscape_stills_sent_total";                // rendered or from the cache
constexpr auto still_cache_hits = "cloudscape_still_cache_hits_total";      // stills that were not rendered again
constexpr auto still_cache_bytes = "cloudscape_still_cache_bytes";          // that the cache holds now
constexpr auto job_frames = "cloudscape_job_frames_total";                  // rendered and written for jobs
constexpr auto job_result_bytes = "cloudscape_job_result_bytes";            // on disk now
constexpr auto bytes_sent = "cloudscape_sent_bytes_total";                  // HTTP and stream payload

// Requests by route pattern and class of status ("2xx").
inline std::string http_requests(std::string_view route, int status) {
  return "cloudscape_http_requests_total{route=\"" + std::string(route) + "\",status=\"" +
         std::to_string(status / 100) + "xx\"}";
}
// Jobs now, and all that ended, by state: queued, rendering, done, failed, cancelled.
inline std::string jobs(std::string_view state) { return "cloudscape_jobs{state=\"" + std::string(state) + "\"}"; }
inline std::string jobs_ended(std::string_view state) {
  return "cloudscape_jobs_ended_total{state=\"" + std::string(state) + "\"}";
}
// What was refused, by reason: connections, streams, token, origin, host, rate, queue, jobs, flood, message_size,
// hello.
inline std::string refused(std::string_view reason) {
  return "cloudscape_refused_total{reason=\"" + std::string(reason) + "\"}";
}

}  // namespace cloudscape::net::metric
