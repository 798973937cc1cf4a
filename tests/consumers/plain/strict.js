// Records the problems that the browser and the fire report.
window.violations = [];
window.failures = [];
document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => {
  violations.push(`${violatedDirective} ${blockedURI}`);
});
// It does not bubble, but it comes by.
addEventListener('error', ({ detail }) => detail && failures.push(detail), true);
