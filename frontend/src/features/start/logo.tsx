/** LearnBlock's mark: a block with a robot's face. */
export function Logo({ size = 36 }: { size?: number }) {
  return (
    <svg class="logo" width={size} height={size} viewBox="0 0 40 40" aria-hidden="true" focusable="false">
      <rect width="40" height="40" rx="11" fill="#4338ca" />
      <path
        d="M9 13a4 4 0 0 1 4-4h2.5c.8 0 1.2.5 1.7 1l.9.9c.4.4.9.6 1.4.6h1c.5 0 1-.2 1.4-.6l.9-.9c.5-.5.9-1 1.7-1H27a4 4 0 0 1 4 4v5H9z"
        fill="#ffc531"
      />
      <rect x="9" y="19.500" width="22" height="11.500" rx="4" fill="#fff" />
      <rect x="14" y="22.600" width="3.600" height="5.400" rx="1.800" fill="#4338ca" />
      <rect x="22.400" y="22.600" width="3.600" height="5.400" rx="1.800" fill="#4338ca" />
    </svg>
  );
}
